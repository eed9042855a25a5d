#!/usr/bin/env python3
# The rules of the house hold in this tree.
# SPDX-License-Identifier: MIT

import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import check_architecture  # noqa: E402

sys.exit(check_architecture.main())

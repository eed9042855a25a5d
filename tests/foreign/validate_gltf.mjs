// Runs the Khronos glTF validator on files and prints its reports as one JSON object.
// SPDX-License-Identifier: MIT
// Usage: node validate_gltf.mjs FOLDER_WITH_NODE_MODULES FILE...
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(join(folder, "package.json"))("gltf-validator");
const reports = {};
for (const file of files) {
  reports[file] = await validator.validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 0 });
}
console.log(JSON.stringify(reports));

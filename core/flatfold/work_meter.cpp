// SPDX-License-Identifier: MIT
#include "core/flatfold/work_meter.h"

namespace kiri {

Error WorkMeter::error(const std::string& doneTillThen) const {
  if (isCancelled_) return {ErrorCode::Cancelled, "stopped; " + doneTillThen};
  const std::size_t megabytes = memory_ >> 20;
  return {ErrorCode::BadValue, "finding the layer orders needs more than the " +
                                   std::to_string(megabytes) + " MB of memory that it may use; " +
                                   doneTillThen + "; allow more memory"};
}

}  // namespace kiri

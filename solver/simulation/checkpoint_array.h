#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "solver/recorder.h"

namespace trajan {

/// Throws std::runtime_error if there is none of this name.
template <class T>
const std::vector<T>& checkpoint_array(const Checkpoint& checkpoint, const std::string& name) {
  for (const Checkpoint::Array& array : checkpoint.arrays)
    if (array.name == name) return std::get<std::vector<T>>(array.values);
  throw std::runtime_error("the checkpoint has no array " + name);
}

}  // namespace trajan

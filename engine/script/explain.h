#pragma once
// sim:explain(joint): in plain words why a bond has failed, or why not.
#include <string>

#include "model/model.h"

namespace talus {

std::string explain(const Model& model, int joint);

}  // namespace talus

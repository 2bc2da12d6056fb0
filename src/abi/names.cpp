// SPDX-License-Identifier: MIT
#include "core/enum_names.h"

extern "C" {

#define SHD_CASE(constant, name) \
  case constant:                 \
    return name;
#define SHD_NAME_FUNCTION(type, function, names)                                       \
  const char* function(type value) {                                                   \
    switch (shd::core::enum_bits(value)) { names(SHD_CASE) default : return nullptr; } \
  }
SHD_NAMED_ENUMS(SHD_NAME_FUNCTION)

}  // extern "C"

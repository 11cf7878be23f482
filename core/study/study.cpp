#include "study/study.h"

#include "base/error.h"

namespace lsos {

const char* to_string(Sampling sampling) {
  switch (sampling) {
    case Sampling::random:
      return "random";
    case Sampling::latin_hypercube:
      return "latin_hypercube";
    case Sampling::sobol:
      return "sobol";
    case Sampling::grid:
      break;
  }
  return "grid";
}

const char* to_string(Form form) {
  switch (form) {
    case Form::list:
      return "list";
    case Form::range:
      return "range";
    case Form::uniform:
      return "uniform";
    case Form::normal:
      return "normal";
    case Form::triangular:
      return "triangular";
    case Form::within:
      break;
  }
  return "within";
}

const char* to_string(Keep keep) {
  switch (keep) {
    case Keep::none:
      return "none";
    case Keep::failed:
      return "failed";
    case Keep::all:
      break;
  }
  return "all";
}

}  // namespace lsos

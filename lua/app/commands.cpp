#include "lua/app/commands.h"

namespace lsos {

const std::vector<Command>& commands() {
  static const std::vector<Command> table{
      {"run", "Simulate a plan", prepare_run},
      {"resume", "Go on with a run that was stopped or killed", prepare_resume},
      {"branch", "What if: go on otherwise from a moment of a run", prepare_branch},
      {"check", "Read and check a plan", prepare_check},
      {"edit", "Change a plan: renumber, shift, enable, disable, merge, repeat, split, mirror",
       prepare_edit},
      {"fsm", "The machine synthesised from a plan, as Graphviz DOT", prepare_fsm},
      {"list", "What a plan can name", prepare_list},
      {"test", "Run scenarios: scripts that say what must come of a mission", prepare_test},
      {"repl", "A prompt with an interactive simulation; piped input is a script", prepare_repl},
      {"schema", "KML <Schema> elements of events, and a plan with one Placemark of each",
       prepare_schema},
      {"import", "Make a plan of spreadsheets, maps and outlines", prepare_import},
      {"export", "Write a plan as a spreadsheet, map or outline", prepare_export},
      {"new", "A plan or script that works, to begin from", prepare_new},
      {"overlay", "Write overlay.kml of a run again from its log", prepare_overlay},
      {"rig", "A single-wheel test bed: one wheel on a soil at given slips", prepare_rig},
      {"terrain", "The ground at given places, as a raster has it and as wheels feel it",
       prepare_terrain},
      {"light", "A map of how much of the Sun the ground sees at a time", prepare_light},
      {"sight", "Whether places see each other over the ground, and maps of what one sees",
       prepare_sight},
      {"picture", "A rover of a run as the Sun or a camera saw it", prepare_picture},
      {"report", "Write report.html of a run again from its log, or a page of several runs",
       prepare_report},
      {"compare", "What differs between runs, or between a run and telemetry", prepare_compare},
      {"verify", "Whether the log of a run is the one that its summary was written of",
       prepare_verify},
      {"sweep", "Run a study: many runs of a plan, of which some numbers vary", prepare_sweep},
      {"sun", "Sun and Earth in the sky of a place", prepare_sun},
  };
  return table;
}

}  // namespace lsos

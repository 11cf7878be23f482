// A log of which cells, or bytes of the file, are changed; read as products read it.
#include <sqlite3.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "fuzz/target.h"
#include "record/log.h"
#include "record/log_difference.h"

namespace {

using lsos::test::Bytes;

std::string log_bytes() {
  const std::string file = lsos::test::scratch_folder() + "/sound.gpkg";
  lsos::LogWriter log(file, "IAU_2015:30100", *lsos::parse_utc("2026-07-01T12:00:00Z").value);
  for (int i = 0; i < 4; ++i) {
    lsos::SampleRow row;
    row.time = lsos::SimTime{2'000'000LL * i};
    row.rover_id = i % 2 == 0 ? "A" : "B";
    row.place = lsos::geodetic_from_degrees(1e-4 * i, -89, 12.5);
    row.speed_mps = 0.5 * i;
    row.event = "Route 1";
    log.write(row);
    log.write(lsos::JointRow{row.time, row.rover_id, "wheel 1", 0.25});
    lsos::PanelRow panel;
    panel.time = row.time;
    panel.rover_id = row.rover_id;
    panel.panel = "top";
    log.write(panel);
    lsos::NoteRow note;
    note.time = row.time;
    note.rover_id = row.rover_id;
    note.name = "fault";
    note.fields_json = R"({"mode":null,"part":null,"repair":false,"share":0.5,"what":"battery"})";
    log.write(note);
  }
  lsos::PairRow pair;
  pair.from_id = "A";
  pair.to_id = "B";
  log.write(pair);
  log.write(lsos::SightIntervalRow{"A", "B", "visible", lsos::SimTime{0}, lsos::SimTime{5}});
  lsos::EventRow event;
  event.rover_id = "A";
  event.sequence = 1;
  event.type = "Route";
  event.label = "Route 1";
  event.ready = event.start = lsos::SimTime{0};
  log.write(event);
  lsos::PlannedPathRow path;
  path.rover_id = "A";
  path.line = {lsos::geodetic_from_degrees(0, -89), lsos::geodetic_from_degrees(0.1, -89)};
  log.write(path);
  log.write(lsos::Checkpoint{lsos::SimTime{0}, lsos::CheckpointKind::kept, 1, "state"});
  log.finish();
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string literal(Bytes& bytes) {
  constexpr const char* odd[] = {"NULL",      "9e999",       "-9e999",  "0",
                                 "-1",        "1e300",       "''",      "x''",
                                 "'fast'",    "x'ff'",       "2000000", "1e10",
                                 "'{\"a\":'", "zeroblob(9)", "'A'",     "CAST(x'ff' AS TEXT)"};
  const std::uint8_t kind = bytes.byte();
  if (kind % 4 == 0) return std::to_string(static_cast<std::int64_t>(bytes.number(8)));
  if (kind % 4 == 1) return std::to_string(std::bit_cast<double>(bytes.number(8)));
  return odd[bytes.byte() % std::size(odd)];
}

// Statements that any program may run on a file.
void change_cells(const std::string& file, Bytes& bytes) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  const auto& layers = lsos::contract_layers();
  while (!bytes.is_empty()) {
    const lsos::LayerSpec& layer = layers[bytes.byte() % layers.size()];
    const std::size_t number = bytes.byte() % (layer.columns.size() + 2);
    const std::string column = number < layer.columns.size()
                                   ? std::string(layer.columns[number].name)
                                   : (number == layer.columns.size() ? "geom" : "fid");
    const std::string where = " WHERE fid = " + std::to_string(bytes.byte() % 5);
    const std::string sql =
        "UPDATE " + std::string(layer.name) + " SET \"" + column + "\" = " + literal(bytes) + where;
    sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr);
  }
  sqlite3_close(database);
}

void read(const std::string& file) {
  const lsos::LogReader log(file);
  log.start();
  log.last_sample_time();
  log.run();
  log.sample_totals();
  log.note_counts(10);
  log.samples();
  log.for_each_joint([](const lsos::JointRow&) {}, {lsos::SimTime{0}, lsos::SimTime{1'000'000}});
  log.panels();
  log.pairs();
  log.sight_intervals();
  log.events();
  log.phases();
  log.planned_paths();
  log.notes();
  log.orders();
  log.branch();
  for (const lsos::CheckpointEntry& entry : log.checkpoints()) log.checkpoint(entry.id);
  log.sha256();
  lsos::first_difference(log, log);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string sound = log_bytes();
  Bytes bytes(data, size);
  const bool are_cells = bytes.byte() % 2 == 0;
  const std::string file = lsos::test::scratch_folder() + "/log.gpkg";
  lsos::test::write_scratch("log.gpkg", are_cells ? sound : lsos::test::patched(sound, bytes));
  if (are_cells) change_cells(file, bytes);
  try {
    read(file);
  } catch (const lsos::InputError&) {
  }
  return 0;
}

// What a rover has to tell since it was last read: notes for the log, and warnings for the user.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lsos {

class RoverJournal {
 public:
  struct Note {
    std::int64_t sequence = 0;  // sequence of the event that wrote it; 0: none
    std::string name, fields_json;
  };

  explicit RoverJournal(std::string rover_id) : rover_id_(std::move(rover_id)) {}

  const std::string& rover_id() const { return rover_id_; }
  // Sets the event that the following notes belong to.
  void set_sequence(std::int64_t sequence) { sequence_ = sequence; }
  std::int64_t sequence() const { return sequence_; }
  // `fields_json`: a JSON object with sorted keys.
  void note(const std::string& name, const std::string& fields_json) {
    notes_.push_back({sequence_, name, fields_json});
    note_bytes_ += sizeof(Note) + name.size() + fields_json.size();
  }
  void warn(const std::string& text) { warnings_.push_back(text); }

  // Notes and warnings since the last call.
  std::vector<Note> take_notes() {
    note_bytes_ = 0;
    return std::exchange(notes_, {});
  }
  // What the notes since then take.
  std::size_t note_bytes() const { return note_bytes_; }
  std::vector<std::string> take_warnings() { return std::exchange(warnings_, {}); }

 private:
  std::string rover_id_;
  std::int64_t sequence_ = 0;  // saved by the rover
  // Not saved: read before each exchange ends.
  std::vector<Note> notes_;
  std::size_t note_bytes_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace lsos

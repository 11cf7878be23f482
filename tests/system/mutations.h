// Changes of files as chance makes them, for tests that search for inputs that break a command.
// Each follows from the state of the random numbers alone.
#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace lsos::test {

using Random = std::mt19937_64;

// A number from 0 up to, without, `count`.
std::size_t any(Random& random, std::size_t count);

// A few bits turned, bytes replaced, pieces cut out or written twice.
std::string mutated_bytes(std::string bytes, Random& random);
// Values of fields, coordinates and attributes replaced by others; elements taken out or doubled.
std::string mutated_kml(std::string kml, Random& random);
// Values replaced by others.
std::string mutated_json(std::string json, Random& random);

// Changes cells of a log, or its tables, as any program may.
void mutate_cells(const std::filesystem::path& log, Random& random);
// Changes bytes of the last checkpoint and gives it the hash that it then must have.
void mutate_checkpoint(const std::filesystem::path& log, Random& random);
// The same for a text that begins with a line, or more, and the hash of what follows.
std::string mutated_after_hash(const std::string& bytes, Random& random);

}  // namespace lsos::test

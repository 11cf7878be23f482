// `lsos-host picture --from VIEW` and `--movie`: pictures of runs by cameras.
#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

struct Pixel {
  int red = 0, green = 0, blue = 0;
  int sum() const { return red + green + blue; }
};

struct Image {
  int width = 0, height = 0;
  std::vector<Pixel> pixels;
  const Pixel& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

Image read_image(const std::string& file) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> data(GDALDataset::Open(file.c_str()));
  if (!data || data->GetRasterCount() != 3) return {};
  Image image{data->GetRasterXSize(), data->GetRasterYSize(), {}};
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(3 * image.width * image.height));
  EXPECT_EQ(data->RasterIO(GF_Read, 0, 0, image.width, image.height, bytes.data(), image.width,
                           image.height, GDT_Byte, 3, nullptr, 3, 3 * image.width, 1, nullptr),
            CE_None);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    image.pixels.push_back({bytes[k], bytes[k + 1], bytes[k + 2]});
  }
  return image;
}

// Number of pixels with a property in the rows from..to, given as fractions of the height.
template <class Is>
int count(const Image& image, double from, double to, const Is& is) {
  int found = 0;
  for (int y = static_cast<int>(from * image.height); y < static_cast<int>(to * image.height);
       ++y) {
    for (int x = 0; x < image.width; ++x) found += is(image.at(x, y)) ? 1 : 0;
  }
  return found;
}

bool is_first_track(const Pixel& p) { return p.red > 240 && p.green < 10 && p.blue < 10; }

// Two SEVs on cratered ground with the Sun 25 degrees high in the west; the first one drives
// eastwards, the second stands beside its route.
class CameraPicture : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<TempFolder>();
    const std::string plan = folder->write(
        "plan.kml",
        kml({{"MissionInfo",
              {{"Planet", "Moon"}, {"StartTime", "2026-01-06T12:00:00Z"}, {"Terrain", "Craters"}},
              ""},
             sev("A", "30,10"),
             sev("B", "30.0012,10.0006"),
             event("Route", "A", 1, {}, line("30,10 30.001,10")),
             event("Pause", "B", 1, {{"Duration", "30"}})}));
    const Outcome outcome = run({plan, "-o", *folder / "run", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  static void TearDownTestSuite() { folder.reset(); }

  static Outcome picture(const Words& more, const Surroundings& where = {}) {
    Words words{"picture", *folder / "run", "-o", *folder / "x.png", "--size", "640"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words, where);
  }
  static Image image(const std::string& from, const std::string& at = "25") {
    const Outcome outcome = picture({"--from", from, "--at", at, "--rover", "A"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read_image(*folder / "x.png");
  }

  static std::unique_ptr<TempFolder> folder;
};
std::unique_ptr<TempFolder> CameraPicture::folder;

TEST_F(CameraPicture, from_behind_shows_ground_sky_track_and_shadow) {
  const Image seen = image("chase");
  ASSERT_EQ(seen.width, 640);
  ASSERT_EQ(seen.height, 360);
  // The sky of the Moon is black; the ground below the horizon is lit.
  EXPECT_EQ(count(seen, 0, 0.05, [](const Pixel& p) { return p.sum() == 0; }), 640 * 18);
  EXPECT_GT(count(seen, 0.3, 0.9, [](const Pixel& p) { return p.sum() > 300; }), 60000);
  // Shadows are far darker; the band of the caption is left out.
  EXPECT_GT(count(seen, 0.5, 0.88, [](const Pixel& p) { return p.sum() < 130; }), 1000);
  EXPECT_GT(count(seen, 0.5, 0.9, is_first_track), 60);
  // The letters of the caption are white.
  EXPECT_GT(count(seen, 0.9, 1, [](const Pixel& p) { return p.sum() == 3 * 255; }), 100);
}

TEST_F(CameraPicture, before_it_has_driven_there_is_no_track) {
  EXPECT_EQ(count(image("chase", "0"), 0, 0.9, is_first_track), 0);
}

// Samples are 2 s apart, so that 25 s lies between two of them.
TEST_F(CameraPicture, moves_between_samples) {
  image("above", "24");
  const std::string first = read_text(*folder / "x.png");
  image("above", "25");
  EXPECT_NE(read_text(*folder / "x.png"), first);
}

TEST_F(CameraPicture, as_the_sun_sees_it_has_a_caption_too) {
  const Image seen = image("sun");
  EXPECT_GT(count(seen, 0.9, 1, [](const Pixel& p) { return p.sum() == 3 * 255; }), 100);
}

TEST_F(CameraPicture, says_when_a_script_is_not_what_it_was) {
  EXPECT_THAT(picture({"--at", "5"}).err, Not(HasSubstr("warning")));
  const TempFolder other;
  other.write("rovers/SEV.lua",
              read_text((repository() / "rovers/SEV.lua").string()) + "\n-- Changed.\n");
  EXPECT_THAT(picture({"--at", "5"}, {.environment = {"LSOS_PATH=" + other.path().string()}}).err,
              HasSubstr("rovers/SEV.lua is not what it was when"));
}

TEST_F(CameraPicture, from_the_east_shows_the_horizon) {
  const Image seen = image("east");
  EXPECT_EQ(count(seen, 0, 0.05, [](const Pixel& p) { return p.sum() == 0; }), 640 * 18);
  EXPECT_GT(count(seen, 0.55, 0.85, [](const Pixel& p) { return p.sum() > 150; }), 20000);
}

TEST_F(CameraPicture, from_above_has_the_shadow_to_the_east_and_the_track_to_the_west) {
  const Image seen = image("above");
  int track_left = 0, track_right = 0, dark_left = 0, dark_right = 0;
  for (int y = 60; y < 300; ++y) {
    for (int x = 0; x < 640; ++x) {
      (x < 320 ? track_left : track_right) += is_first_track(seen.at(x, y)) ? 1 : 0;
      if (y > 140 && y < 220) (x < 320 ? dark_left : dark_right) += seen.at(x, y).sum() < 130;
    }
  }
  EXPECT_GT(track_left, 300);
  EXPECT_LT(track_right, 30);
  EXPECT_GT(dark_right, dark_left + 500);
}

TEST_F(CameraPicture, from_a_rover_shows_another_one_and_what_lies_ahead) {
  const auto is_sky = [](const Pixel& p) { return p.sum() == 0; };
  for (const std::string from : {"A", "B"}) {
    const Image seen = image(from);
    EXPECT_GT(count(seen, 0, 0.2, is_sky), 10000) << from;
    EXPECT_GT(count(seen, 0.5, 0.85, [](const Pixel& p) { return p.sum() > 300; }), 5000) << from;
  }
}

TEST_F(CameraPicture, is_the_same_again) {
  image("chase");
  const std::string first = read_text(*folder / "x.png");
  image("chase");
  EXPECT_EQ(read_text(*folder / "x.png"), first);
}

TEST_F(CameraPicture, tells_what_it_shows) {
  const json answer = json::parse(picture({"--from", "east", "--at", "25", "--rover", "B"}).out)[0];
  EXPECT_EQ(answer["rover_id"], "B");
  EXPECT_EQ(answer["from"], "east");
  EXPECT_EQ(answer["width_px"], 640);
  EXPECT_EQ(answer["height_px"], 360);
}

TEST_F(CameraPicture, names_the_views_there_are) {
  const Outcome outcome = picture({"--at", "25", "--from", "chaise"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--from chaise: no such view; there are sun, chase, east, "
                                     "above, and from the rovers A, B; did you mean 'chase'?"));
}

TEST_F(CameraPicture, says_which_options_go_together) {
  EXPECT_THAT(picture({}).err, HasSubstr("--at is missing"));
  EXPECT_THAT(picture({"--at", "5", "--every", "2"}).err,
              HasSubstr("--every 2: only with --movie"));
  EXPECT_THAT(picture({"--at", "5", "--movie"}).err, HasSubstr("--at 5: a --movie shows all"));
  EXPECT_THAT(picture({"--movie"}).err, HasSubstr("x.png: the name must end in .mp4"));
  const auto into = [](const std::string& file, const Words& more) {
    Words words{"picture", *folder / "run", "-o", *folder / file};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(into("x.mp4", {"--at", "5"}), HasSubstr("x.mp4: a film is made with --movie"));
  EXPECT_THAT(into("x.mp4", {"--movie", "--size", "65"}),
              HasSubstr("--size 65: a --movie's must be even"));
  EXPECT_THAT(into("run/plan.kml", {"--at", "5"}), HasSubstr("the name must end in .png"));
  EXPECT_THAT(into("no/x.png", {"--at", "5"}), HasSubstr("no/x.png: there is no folder "));
}

class Film : public CameraPicture {
 protected:
  static Outcome film(const Words& more, const std::string& path) {
    Words words{"picture", *folder / "run", "-o",    *folder / "x.mp4", "--size",
                "64",      "--from",        "above", "--movie"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words, {.environment = {"PATH=" + path}});
  }
  static bool leaves_nothing() {
    return std::ranges::none_of(
        std::filesystem::directory_iterator(folder->path()),
        [](const auto& entry) { return entry.path().filename().string().starts_with("x.mp4"); });
  }
  // Writes a shell script with this body that replaces ffmpeg, and returns a PATH that finds it.
  // The film's name is its last argument.
  static std::string program(const std::string& name, const std::string& body) {
    const std::string file = folder->write(name + "/ffmpeg", "#!/bin/sh\n" + body + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return (*folder / name).string() + ":/usr/bin:/bin";
  }
};

TEST_F(Film, needs_ffmpeg) {
  const Outcome outcome = film({"--every", "10"}, "");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("ffmpeg, which is not installed: apt-get install ffmpeg"));
  EXPECT_TRUE(leaves_nothing());
}

TEST_F(Film, gives_it_all_pictures) {
  const std::string path = program("counts", "for file; do :; done; wc -c > \"${file#file:}\"");
  const Outcome outcome = film({"--every", "10"}, path);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const int pictures = json::parse(outcome.out)[0]["pictures"];
  EXPECT_GE(pictures, 3);
  EXPECT_EQ(std::stoi(read_text(*folder / "x.mp4")), pictures * 64 * 36 * 3);
  std::filesystem::remove(*folder / "x.mp4");
}

TEST_F(Film, looks_from_behind_unless_it_is_told_otherwise) {
  const std::string path = program("eats", "for file; do :; done; cat > \"${file#file:}\"");
  const Outcome outcome = run({"picture", *folder / "run", "-o", *folder / "x.mp4", "--size", "64",
                               "--movie", "--every", "20"},
                              {.environment = {"PATH=" + path}});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json about = json::parse(outcome.out)[0];
  EXPECT_EQ(about["from"], "chase");
  EXPECT_EQ(about["times_real_time"], 20 * 25);
  std::filesystem::remove(*folder / "x.mp4");
}

TEST_F(Film, is_stopped_from_outside_and_leaves_nothing) {
  const std::string path = program("waits", "cat > /dev/null; sleep 60");
  Process process({LSOS_PROGRAM, "picture", *folder / "run", "-o", *folder / "x.mp4", "--size",
                   "64", "--from", "above", "--movie", "--every", "0.1"},
                  {.environment = {"PATH=" + path}});
  std::this_thread::sleep_for(std::chrono::seconds(2));
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_TRUE(leaves_nothing());
}

TEST_F(Film, leaves_nothing_when_ffmpeg_fails) {
  const std::string path =
      program("fails", "for file; do :; done; echo half > \"${file#file:}\"; exit 3");
  EXPECT_EQ(film({"--every", "10"}, path).exit_code, 3);
  EXPECT_TRUE(leaves_nothing());
}

TEST_F(Film, refuses_a_time_between_pictures_that_is_none) {
  for (const std::string every : {"soon", "0", "-5", "0.001"}) {
    const Outcome outcome = film({"--every=" + every}, "/usr/bin:/bin");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--every " + every + ": "));
  }
  EXPECT_THAT(film({"--every", "soon"}, "").err, HasSubstr("as 10 s or 2 min"));
}

}  // namespace
}  // namespace lsos::test

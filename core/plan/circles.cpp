// Finds events that wait for each other in a circle.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "plan/references.h"

namespace lsos {

namespace {

// An edge of the graph of waits: the event that another one waits for.
struct Wait {
  std::size_t to;
  bool is_start_after;  // false: `to` is the event before it on the same rover
};

// The waits of each event. A disabled event counts as ended at time 0: nothing waits for it, and it
// waits for nothing.
std::vector<std::vector<Wait>> waits_of(const std::vector<DraftEvent>& drafts) {
  const auto takes_part = [](const DraftEvent& d) { return d.is_placed && d.event.is_enabled; };
  std::map<PlanEvent::Reference, std::size_t> by_identity;
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    const PlanEvent& event = drafts[i].event;
    if (takes_part(drafts[i])) by_identity[{event.rover_id, event.sequence}] = i;
  }
  std::vector<std::vector<Wait>> waits(drafts.size());
  std::size_t before = drafts.size();
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    if (!takes_part(drafts[i])) continue;
    const PlanEvent& event = drafts[i].event;
    for (const PlanEvent::Reference& awaited : event.start_after) {
      const auto found = by_identity.find(awaited);
      if (found != by_identity.end()) waits[i].push_back({found->second, true});
    }
    if (event.at) continue;  // comes in no turn, and no other waits for its turn
    if (before < i && drafts[before].event.rover_id == event.rover_id) {
      waits[i].push_back({before, false});
    }
    before = i;
  }
  return waits;
}

struct Step {
  std::size_t event;
  std::size_t next_wait = 0;  // index into its waits, one past the wait that is followed
};

// "A waits for B, which comes after C, which waits for A". Consecutive "comes after" on one rover
// are merged into one.
std::string circle_text(const std::vector<Step>& circle,
                        const std::vector<std::vector<Wait>>& waits,
                        const std::vector<DraftEvent>& drafts) {
  std::string text = named(drafts[circle.front().event]);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    const auto wait = [&](const Step& step) { return waits[step.event][step.next_wait - 1]; };
    const bool is_start_after = wait(circle[i]).is_start_after;
    const Step& next = circle[(i + 1) % circle.size()];
    if (!is_start_after && !wait(next).is_start_after) continue;
    text += fmt::format("{} {} {}", i == 0 ? "" : ", which",
                        is_start_after ? "waits for" : "comes after", named(drafts[next.event]));
  }
  return text;
}

class CircleFinder {
 public:
  CircleFinder(const std::vector<DraftEvent>& drafts, Faults& faults)
      : drafts_(drafts), faults_(faults), waits_(waits_of(drafts)), colours_(drafts.size()) {}

  // Depth-first search without recursion: plans may have chains of thousands of events.
  void run() {
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
      if (colours_[i] == Colour::unseen) search(i);
    }
  }

 private:
  enum class Colour { unseen, on_path, done };

  void search(std::size_t start) {
    path_.assign(1, {start});
    colours_[start] = Colour::on_path;
    while (!path_.empty()) {
      Step& step = path_.back();
      if (step.next_wait == waits_[step.event].size()) {
        colours_[step.event] = Colour::done;
        path_.pop_back();
        continue;
      }
      const std::size_t to = waits_[step.event][step.next_wait++].to;
      if (colours_[to] == Colour::unseen) {
        colours_[to] = Colour::on_path;
        path_.push_back({to});
      } else if (colours_[to] == Colour::on_path) {
        report(to);
      }
    }
  }

  // The circle is the end of the path from `first` on. When circles share an event, only the first
  // found is reported: mending it often mends the others.
  void report(std::size_t first) {
    auto begin = std::ranges::find(path_, first, &Step::event);
    std::vector<Step> circle(begin, path_.end());
    for (const Step& step : circle) {
      if (is_reported_.contains(step.event)) return;
    }
    for (const Step& step : circle) is_reported_.insert(step.event);
    // The message begins with the earliest event whose StartAfter is part of the circle. There is
    // one, because "comes after" alone never leads back.
    auto start = circle.end();
    for (auto step = circle.begin(); step != circle.end(); ++step) {
      if (!waits_[step->event][step->next_wait - 1].is_start_after) continue;
      if (start == circle.end() || step->event < start->event) start = step;
    }
    LSOS_ASSERT(start != circle.end());
    std::rotate(circle.begin(), start, circle.end());
    const DraftEvent& draft = drafts_[circle.front().event];
    const int line =
        draft.start_after == nullptr ? draft.event.place.line : draft.start_after->line;
    faults_.error({draft.event.place.file, line},
                  fmt::format("{}: StartAfter goes in a circle: {}", draft.subject,
                              circle_text(circle, waits_, drafts_)));
  }

  const std::vector<DraftEvent>& drafts_;
  Faults& faults_;
  std::vector<std::vector<Wait>> waits_;
  std::vector<Colour> colours_;
  std::vector<Step> path_;
  std::set<std::size_t> is_reported_;
};

}  // namespace

void check_circles(const std::vector<DraftEvent>& drafts, Faults& faults) {
  CircleFinder(drafts, faults).run();
}

}  // namespace lsos

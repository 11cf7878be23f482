// Finds events that wait for each other in a circle.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/circles.h"
#include "plan/field_reader.h"
#include "plan/references.h"

namespace lsos {

namespace {

// An edge of the graph of waits: the event that another one waits for, and why.
struct Wait {
  enum class Kind { start_after, order, follows };
  std::size_t to;
  Kind kind;
  std::string leader_id = {};  // follows only
};

// The graph of waits.
class Waits {
 public:
  Waits(const std::vector<DraftEvent>& drafts, const Declarations& declarations)
      : drafts_(drafts), declarations_(declarations), of_(drafts.size()) {
    // A disabled event counts as ended at time 0: nothing waits for it, and it waits for nothing.
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      const PlanEvent& event = drafts[i].event;
      if (!takes_part(i)) continue;
      by_identity_[{event.rover_id, event.sequence}] = i;
      if (!event.at) last_of_[event.rover_id] = i;
    }
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      if (takes_part(i)) add(i, before);
    }
  }

  const std::vector<Wait>& of(std::size_t event) const { return of_[event]; }
  std::vector<std::vector<std::size_t>> edges() const {
    std::vector<std::vector<std::size_t>> edges(of_.size());
    for (std::size_t i = 0; i < of_.size(); ++i) {
      for (const Wait& wait : of_[i]) edges[i].push_back(wait.to);
    }
    return edges;
  }

 private:
  bool takes_part(std::size_t i) const {
    return drafts_[i].is_placed && drafts_[i].event.is_enabled;
  }

  void add(std::size_t i, std::optional<std::size_t>& before) {
    const PlanEvent& event = drafts_[i].event;
    for (const PlanEvent::Reference& awaited : event.start_after) {
      const auto found = by_identity_.find(awaited);
      if (found != by_identity_.end()) of_[i].push_back({found->second, Wait::Kind::start_after});
    }
    if (event.at) return;  // comes in no turn, and no other waits for its turn
    if (before && drafts_[*before].event.rover_id == event.rover_id) {
      of_[i].push_back({*before, Wait::Kind::order});
    }
    before = i;
    const std::string leader_id = followed_to_the_end(event);
    const auto last = last_of_.find(leader_id);
    if (last != last_of_.end()) of_[i].push_back({last->second, Wait::Kind::follows, leader_id});
  }

  // The rover that an event follows until all events of that one have ended; "": it follows none,
  // or a duration, a Timeout or a condition ends it before.
  std::string followed_to_the_end(const PlanEvent& event) const {
    const auto declared = declarations_.events.find(event.type);
    if (declared == declarations_.events.end()) return "";
    if (event.timeout || !event.stop_when.text.empty()) return "";
    const std::string* leader_id = find_name(event.params, declared->second, NameOf::leader);
    const bool has_end = std::ranges::any_of(declared->second.fields, [&](const auto& field) {
      return field.kind == FieldKind::duration && event.params.contains(field.key);
    });
    return leader_id == nullptr || has_end ? "" : *leader_id;
  }

  const std::vector<DraftEvent>& drafts_;
  const Declarations& declarations_;
  std::map<PlanEvent::Reference, std::size_t> by_identity_;
  std::map<std::string, std::size_t> last_of_;  // by RoverId, the last event with a turn
  std::vector<std::vector<Wait>> of_;
};

// "A waits for B, which comes after C, which follows R until A has ended". Consecutive "comes
// after" on one rover are merged into one.
std::string circle_text(const std::vector<CircleStep>& circle, const Waits& waits,
                        const std::vector<DraftEvent>& drafts) {
  const auto wait = [&](const CircleStep& step) { return waits.of(step.node)[step.edge]; };
  std::string text = named(drafts[circle.front().node]);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    const CircleStep& next = circle[(i + 1) % circle.size()];
    const Wait along = wait(circle[i]);
    const std::string to = named(drafts[next.node]);
    text += i == 0 ? " " : ", which ";
    switch (along.kind) {
      case Wait::Kind::start_after:
        text += "waits for " + to;
        break;
      case Wait::Kind::order:
        while (i + 1 < circle.size() && wait(circle[i + 1]).kind == Wait::Kind::order) ++i;
        text += "comes after " + named(drafts[circle[(i + 1) % circle.size()].node]);
        break;
      case Wait::Kind::follows:
        text += fmt::format("follows {} until {} has ended", along.leader_id, to);
        break;
    }
  }
  return text;
}

}  // namespace

// When circles share an event, only the first found is reported: mending it often mends the others.
void check_circles(const std::vector<DraftEvent>& drafts, const Declarations& declarations,
                   Faults& faults) {
  const Waits waits(drafts, declarations);
  std::set<std::size_t> is_reported;
  for (std::vector<CircleStep>& circle : find_circles(waits.edges())) {
    const auto was_reported = [&](const CircleStep& step) {
      return is_reported.contains(step.node);
    };
    if (std::ranges::any_of(circle, was_reported)) continue;
    // The message begins with the earliest event whose StartAfter is part of the circle. There is
    // none where rovers only follow each other, which check_followings() reports.
    auto start = circle.end();
    for (auto step = circle.begin(); step != circle.end(); ++step) {
      if (waits.of(step->node)[step->edge].kind != Wait::Kind::start_after) continue;
      if (start == circle.end() || step->node < start->node) start = step;
    }
    if (start == circle.end()) continue;
    for (const CircleStep& step : circle) is_reported.insert(step.node);
    std::rotate(circle.begin(), start, circle.end());
    const DraftEvent& draft = drafts[circle.front().node];
    const int line =
        draft.start_after == nullptr ? draft.event.place.line : draft.start_after->line;
    faults.error({draft.event.place.file, line},
                 fmt::format("{}: StartAfter goes in a circle: {}", draft.subject,
                             circle_text(circle, waits, drafts)));
  }
}

}  // namespace lsos

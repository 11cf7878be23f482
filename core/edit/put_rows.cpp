#include "edit/put_rows.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "edit/placemark_edit.h"

namespace lsos {

namespace {

using Kind = ThingKey::Kind;

class RowPutter {
 public:
  explicit RowPutter(PlanDocument& document) : document_(document) {
    const Plan& plan = document.plan();
    marks_[{}] = document.mission();
    for (const PlanRover& rover : plan.rovers) {
      marks_[{Kind::rover, rover.id}] = document.rover(rover.id);
    }
    for (const PlanAsset& asset : plan.assets) {
      marks_[{Kind::asset, asset.id}] = document.asset(asset.id);
    }
    for (const PlanEvent& event : plan.events) {
      marks_[{Kind::event, event.rover_id, event.sequence}] = document.mark(event);
    }
  }

  void change(const RowChange& change) {
    PlanMark& mark = marks_.at(change.key);
    const SourcePlacemark& after = change.after;
    if (change.has_new_type) set_type(document_, mark, after.data.front().schema);
    for (const std::string& name : change.fields) {
      const std::string text = field_of(after, name);
      if (text.empty()) {
        document_.erase_field(mark, name);
      } else {
        document_.set_field(mark, name, text);
      }
    }
    if (change.has_new_name) put_text(mark, "name", after.name);
    if (change.has_new_description) put_text(mark, "description", after.description);
    if (change.has_new_place) put_places(mark, after);
  }

  void add(const RowChange& added) {
    const SourcePlacemark& thing = added.after;
    const std::string& type = thing.data.front().schema;
    const PlanMark like = kin(added.key, type);
    PlanMark mark = place_beside(added.key, like);
    std::vector<std::string> names;
    for (const SourceField& field : thing.data.front().fields) names.push_back(field.name);
    if (mark.type != type) set_type(document_, mark, type);
    keep_fields(document_, mark, names);
    for (const SourceField& field : thing.data.front().fields) {
      document_.set_field(mark, field.name, field.text);
    }
    put_text(mark, "name", thing.name);
    put_text(mark, "description", thing.description);
    put_places(mark, thing);
    marks_[added.key] = mark;
  }

  void remove(const ThingKey& key) {
    document_.dom().remove(marks_.at(key).element);
    marks_.erase(key);
  }

 private:
  using Marks = std::map<ThingKey, PlanMark>;

  // The Placemark that a new one is made like: the nearest before it of its type and rover, else
  // one of its type, else one of its rover, else any of its kind.
  const PlanMark& kin(const ThingKey& key, const std::string& type) const {
    const PlanMark* best = nullptr;
    int most = 0;
    for (const auto& [other, mark] : marks_) {
      if (other.kind == Kind::mission) continue;
      const bool is_of_rover = other.id == key.id, is_earlier = other < key;
      const int worth = 8 * (other.kind == key.kind) + 4 * (mark.type == type) + 2 * is_of_rover +
                        (is_earlier ? 1 : 0);
      const bool is_nearer = worth == most && is_earlier;  // marks come in order
      if (worth <= most && !is_nearer) continue;
      best = &mark;
      most = worth;
    }
    LSOS_ASSERT(best != nullptr);
    return *best;
  }

  PlanMark place_beside(const ThingKey& key, const PlanMark& like) {
    const auto after = marks_.upper_bound(key);
    const bool has_next = after != marks_.end() && is_neighbour(after->first, key);
    const bool has_previous = after != marks_.begin() && is_neighbour(std::prev(after)->first, key);
    if (has_previous && lies_with(std::prev(after)->second, like)) {
      return copy_of_kind(document_, like, std::prev(after)->second.element, Beside::behind);
    }
    if (has_next && lies_with(after->second, like)) {
      return copy_of_kind(document_, like, after->second.element, Beside::before);
    }
    return copy_of_kind(document_, like, like.element, Beside::behind);
  }

  static bool is_neighbour(const ThingKey& other, const ThingKey& key) {
    return other.kind == key.kind && (key.kind != Kind::event || other.id == key.id);
  }

  // Whether a new Placemark like `like` belongs beside the one before it: folders may hold days, or
  // rovers, or what is of one type.
  bool lies_with(const PlanMark& neighbour, const PlanMark& like) const {
    const KmlElement folder = parent_of(neighbour.element);
    if (folder == parent_of(like.element)) return true;
    return std::ranges::any_of(marks_, [&](const auto& entry) {
      return parent_of(entry.second.element) == folder && entry.second.type != neighbour.type;
    });
  }

  void put_text(const PlanMark& mark, const char* name, const std::string& text) {
    const KmlElement old = child(mark.element, name);
    if (text.empty()) {
      if (old != nullptr) document_.dom().remove(old);
    } else if (old != nullptr) {
      set_text(old, text);
    } else {
      document_.dom().add_feature_part(mark.element, name, text);
    }
  }

  void put_places(const PlanMark& mark, const SourcePlacemark& thing) {
    set_places(document_, mark,
               thing.geometries.empty() ? SourceGeometry{} : thing.geometries.front());
  }

  PlanDocument& document_;
  Marks marks_;
};

}  // namespace

void put_rows(PlanDocument& document, const RowChanges& changes,
              const std::vector<ThingKey>& removed) {
  RowPutter putter(document);
  for (const RowChange& change : changes.changed) putter.change(change);
  for (const RowChange& added : changes.added) putter.add(added);
  for (const ThingKey& key : removed) putter.remove(key);
}

}  // namespace lsos

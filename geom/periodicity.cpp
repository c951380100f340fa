// SPDX-License-Identifier: BSD-3-Clause
// Motions are tried by what they do to vertices, and proved on edges and faces.
#include "geom/periodicity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "geom/facets.h"
#include "geom/motion_search.h"

namespace octet {
namespace {

constexpr double kShareOfDiagonal = 1e-6;  ///< how far images may be off, where the CAD is as exact

[[noreturn]] void refuse(const PeriodicFaces& wish, const std::string& why) {
  throw InputError("--periodic \"" + wish.words + "\": " + why);
}

/// A wish and the motion that meets it.
struct Step {
  const PeriodicFaces* wish;
  std::vector<int> edges, images;  ///< of the closures
  Motion motion;
  std::vector<std::pair<int, int>> faces;
};

void check_once(const Model& model, const std::vector<PeriodicFaces>& wishes) {
  std::vector<bool> has_image(static_cast<std::size_t>(model.count(2)) + 1, false), is_image = has_image;
  for (const PeriodicFaces& wish : wishes) {
    for (const int f : wish.faces) {
      if (std::find(wish.images.begin(), wish.images.end(), f) != wish.images.end())
        refuse(wish, model.describe(model_face(f)) + " would be its own image");
      if (has_image[static_cast<std::size_t>(f)])
        refuse(wish, model.describe(model_face(f)) + " has an image already");
      has_image[static_cast<std::size_t>(f)] = true;
    }
    for (const int f : wish.images) {
      if (is_image[static_cast<std::size_t>(f)])
        refuse(wish, model.describe(model_face(f)) + " is an image already");
      is_image[static_cast<std::size_t>(f)] = true;
    }
  }
}

double tolerance_of_all(const Model& model, const std::vector<PeriodicFaces>& wishes) {
  double tolerance = kShareOfDiagonal * model.diagonal();
  for (const PeriodicFaces& wish : wishes)
    for (const std::vector<int>& faces : {wish.faces, wish.images})
      for (const int f : faces) {
        for (const int v : model.face(f).vertices)
          tolerance = std::max(tolerance, 2.0 * model.tolerance_of(model_vertex(v)));
        for (const FaceBoundary& side : model.face(f).boundary)
          tolerance = std::max(tolerance, 2.0 * model.tolerance_of(model_edge(side.edge)));
      }
  return tolerance;
}

/// A place on one of some edges.
struct PlaceOnEdge {
  int edge = 0;
  EdgeFoot foot;
};

PlaceOnEdge nearest_of(const Model& model, const std::vector<int>& edges, const Vec3& p) {
  PlaceOnEdge best;
  best.foot.distance = std::numeric_limits<double>::infinity();
  for (const int e : edges)
    if (const EdgeFoot foot = model.edge_closest(e, p); foot.distance < best.foot.distance) best = {e, foot};
  return best;
}

/// Edges in pieces: parameters of their ends per edge tag, those of the edge first and last.
class Pieces {
 public:
  Pieces(const Model& model, const std::vector<Step>& steps, double tolerance)
      : model_(model), tolerance_(tolerance), ends_(static_cast<std::size_t>(model.count(1)) + 1) {
    for (const Step& step : steps)
      for (const std::vector<int>& edges : {step.edges, step.images})
        for (const int e : edges) ends_[at(e)] = {model.edge(e).t0, model.edge(e).t1};
    // An end makes an end wherever it is taken to, from there as well.
    constexpr int kMost = 32;
    bool any = true;
    for (int round = 0; any && round < kMost; ++round) {
      any = false;
      for (const Step& step : steps) {
        any = take_ends(step.edges, step.images, step.motion) || any;
        any = take_ends(step.images, step.edges, step.motion.inverse()) || any;
      }
    }
  }

  [[nodiscard]] const std::vector<double>& ends(int edge) const { return ends_[at(edge)]; }

  /// Which piece of these edges holds a place.
  [[nodiscard]] std::pair<int, std::size_t> piece_at(const std::vector<int>& edges, const Vec3& p) const {
    const PlaceOnEdge place = nearest_of(model_, edges, p);
    const std::vector<double>& ends = ends_[at(place.edge)];
    const auto above = std::upper_bound(ends.begin() + 1, ends.end() - 1, place.foot.t);
    return {place.edge, static_cast<std::size_t>(above - ends.begin()) - 1};
  }

  [[nodiscard]] Vec3 middle(int edge, std::size_t piece) const {
    return model_.edge_point(edge, 0.5 * (ends_[at(edge)][piece] + ends_[at(edge)][piece + 1]));
  }

 private:
  static std::size_t at(int tag) { return static_cast<std::size_t>(tag); }

  bool take_ends(const std::vector<int>& from, const std::vector<int>& to, const Motion& motion) {
    bool any = false;
    if (to.empty()) return any;
    for (const int e : from)
      for (const double t : std::vector<double>(ends_[at(e)])) {
        const PlaceOnEdge place = nearest_of(model_, to, motion(model_.edge_point(e, t)));
        std::vector<double>& ends = ends_[at(place.edge)];
        const bool known = std::any_of(ends.begin(), ends.end(), [&](double other) {
          return (model_.edge_point(place.edge, other) - place.foot.point).norm() <= 4.0 * tolerance_;
        });
        if (known) continue;
        ends.insert(std::lower_bound(ends.begin(), ends.end(), place.foot.t), place.foot.t);
        any = true;
      }
    return any;
  }

  const Model& model_;
  double tolerance_;
  std::vector<std::vector<double>> ends_;
};

/// Something and where it is taken; `words` are those of the wish.
template <class Item>
struct Link {
  Item from, to;
  Motion motion;
  const std::string* words;
};

/// An item of an orbit, and the motion from the first.
template <class Item>
using Orbit = std::vector<std::pair<Item, Motion>>;

/// All orbits of items along links, from items that are no images on, then from others. `places(item)`: by
/// which two motions of it are told apart; `describe(item)`: for messages.
template <class Item, class Places, class Describe>
std::vector<Orbit<Item>> orbits_of(const std::vector<Link<Item>>& links, double tolerance,
                                   const Places& places, const Describe& describe) {
  std::vector<Item> firsts, reached;
  for (const Link<Item>& link : links)
    if (link.from != link.to) reached.push_back(link.to);
  std::sort(reached.begin(), reached.end());
  for (const bool late : {false, true})
    for (const Link<Item>& link : links)
      for (const Item& item : {link.from, link.to})
        if (std::binary_search(reached.begin(), reached.end(), item) == late) firsts.push_back(item);
  std::vector<Item> done;
  std::vector<Orbit<Item>> orbits;
  for (const Item& first : firsts) {
    if (std::find(done.begin(), done.end(), first) != done.end()) continue;
    Orbit<Item> orbit{{first, {}}};
    const std::vector<Vec3> own = places(first);
    const auto reach = [&](const Item& item, const Motion& motion, const std::string& words) {
      const auto known =
          std::find_if(orbit.begin(), orbit.end(), [&](const auto& member) { return member.first == item; });
      if (known == orbit.end()) {
        orbit.emplace_back(item, motion);
        return;
      }
      for (const Vec3& p : own)
        if ((known->second(p) - motion(p)).norm() > 4.0 * tolerance)
          throw InputError("--periodic \"" + words + "\": " + describe(item) +
                           " would be its own image in another place");
    };
    for (std::size_t i = 0; i < orbit.size(); ++i)
      for (const Link<Item>& link : links) {
        const auto [item, motion] = orbit[i];
        if (link.from == item) reach(link.to, link.motion.after(motion), *link.words);
        if (link.to == item) reach(link.from, link.motion.inverse().after(motion), *link.words);
      }
    for (const auto& member : orbit) done.push_back(member.first);
    orbits.push_back(std::move(orbit));
  }
  return orbits;
}

std::vector<std::vector<OrbitMember>> members_of(const std::vector<Orbit<int>>& orbits) {
  std::vector<std::vector<OrbitMember>> result;
  for (const Orbit<int>& orbit : orbits) {
    result.emplace_back();
    for (const auto& [tag, motion] : orbit) result.back().push_back({tag, motion});
  }
  return result;
}

/// Vertices that are taken to vertices; of those that are taken elsewhere, none.
std::vector<std::vector<OrbitMember>> vertex_orbits(const Model& model, const std::vector<Step>& steps,
                                                    double tolerance) {
  std::vector<Link<int>> links;
  std::vector<int> alone;
  for (const Step& step : steps) {
    const std::vector<int> from = vertices_of(model, step.wish->faces),
                           to = vertices_of(model, step.wish->images);
    const auto image = [&](int v, const std::vector<int>& among, const Motion& motion) {
      const Vec3 p = motion(model.vertex(v).point);
      const auto found = std::find_if(among.begin(), among.end(), [&](int w) {
        return (model.vertex(w).point - p).norm() <= 2.0 * tolerance;
      });
      return found == among.end() ? 0 : *found;
    };
    for (const int v : from) {
      const int w = image(v, to, step.motion);
      if (w == 0)
        alone.push_back(v);
      else
        links.push_back({v, w, step.motion, &step.wish->words});
    }
    for (const int w : to)
      if (image(w, from, step.motion.inverse()) == 0) alone.push_back(w);
  }
  auto orbits = members_of(orbits_of(
      links, tolerance, [&](int v) { return std::vector<Vec3>{model.vertex(v).point}; },
      [&](int v) { return model.describe(model_vertex(v)); }));
  std::erase_if(orbits, [&](const std::vector<OrbitMember>& orbit) {
    return std::any_of(orbit.begin(), orbit.end(), [&](const OrbitMember& member) {
      return std::find(alone.begin(), alone.end(), member.tag) != alone.end();
    });
  });
  return orbits;
}

}  // namespace

Periodicity::Periodicity(const Model& model, const std::vector<PeriodicFaces>& wishes) {
  if (wishes.empty()) return;
  check_once(model, wishes);
  tolerance_ = tolerance_of_all(model, wishes);
  std::vector<Step> steps;
  for (const PeriodicFaces& wish : wishes) {
    const MotionFound found = find_motion(model, wish.faces, wish.images, wish.axis, tolerance_);
    if (!found.reason.empty()) refuse(wish, found.reason);
    steps.push_back(
        {&wish, edges_of(model, wish.faces), edges_of(model, wish.images), found.motion, found.faces});
  }

  std::vector<Link<int>> faces;
  for (const Step& step : steps)
    for (const auto& [face, image] : step.faces)
      faces.push_back({face, image, step.motion, &step.wish->words});
  faces_ = members_of(orbits_of(
      faces, tolerance_, [&](int f) { return points_within(model, f); },
      [&](int f) { return model.describe(model_face(f)); }));
  orbit_of_face_.assign(static_cast<std::size_t>(model.count(2)) + 1, 0);
  for (std::size_t i = 0; i < faces_.size(); ++i)
    for (const OrbitMember& member : faces_[i]) orbit_of_face_[static_cast<std::size_t>(member.tag)] = i + 1;

  vertices_ = vertex_orbits(model, steps, tolerance_);

  using PieceKey = std::pair<int, std::size_t>;
  const Pieces pieces(model, steps, tolerance_);
  std::vector<Link<PieceKey>> links;
  for (const Step& step : steps)
    for (const int e : step.edges)
      for (std::size_t i = 0; i + 1 < pieces.ends(e).size(); ++i)
        links.push_back({{e, i},
                         pieces.piece_at(step.images, step.motion(pieces.middle(e, i))),
                         step.motion,
                         &step.wish->words});
  pieces_of_.resize(static_cast<std::size_t>(model.count(1)) + 1);
  for (const Orbit<PieceKey>& orbit : orbits_of(
           links, tolerance_,
           [&](const PieceKey& piece) { return std::vector<Vec3>{pieces.middle(piece.first, piece.second)}; },
           [&](const PieceKey& piece) { return model.describe(model_edge(piece.first)); })) {
    pieces_.emplace_back();
    for (const auto& [piece, motion] : orbit) {
      const std::vector<double>& ends = pieces.ends(piece.first);
      pieces_.back().push_back({piece.first, ends[piece.second], ends[piece.second + 1], motion});
      pieces_of_[static_cast<std::size_t>(piece.first)].push_back(pieces_.size() - 1);
    }
  }
  const auto begin_of = [&](std::size_t orbit, int edge) {
    double least = std::numeric_limits<double>::infinity();
    for (const PieceMember& member : pieces_[orbit])
      if (member.edge == edge) least = std::min(least, member.t0);
    return least;
  };
  for (int e = 1; e <= model.count(1); ++e) {
    std::vector<std::size_t>& own = pieces_of_[static_cast<std::size_t>(e)];
    std::sort(own.begin(), own.end(),
              [&](std::size_t a, std::size_t b) { return begin_of(a, e) < begin_of(b, e); });
    if (!own.empty() && own.size() + 1 != pieces.ends(e).size())
      throw InputError("--periodic: " + model.describe(model_edge(e)) +
                       " has pieces without images, or such as are each other's");
  }
}

Periodicity Periodicity::turned(const Eigen::Matrix3d& turn) const {
  Periodicity result = *this;
  const auto turn_over = [&](auto& orbits) {
    for (auto& orbit : orbits)
      for (auto& member : orbit)
        member.motion = {turn * member.motion.turn * turn.transpose(), turn * member.motion.shift};
  };
  turn_over(result.vertices_);
  turn_over(result.pieces_);
  turn_over(result.faces_);
  return result;
}

bool Periodicity::is_whole(const std::vector<PieceMember>& orbit) const {
  return std::all_of(orbit.begin(), orbit.end(),
                     [&](const PieceMember& member) { return pieces_of(member.edge).size() == 1; });
}

bool Periodicity::holds(ModelRef entity) const {
  const auto tag = static_cast<std::size_t>(entity.tag);
  if (entity.dim == 1) return tag < pieces_of_.size() && !pieces_of_[tag].empty();
  return entity.dim == 2 && tag < orbit_of_face_.size() && orbit_of_face_[tag] != 0;
}

std::vector<OrbitMember> Periodicity::images_on_edges(int edge, double t) const {
  std::vector<OrbitMember> images;
  if (!holds(model_edge(edge))) return images;
  for (const std::size_t number : pieces_of(edge)) {
    const std::vector<PieceMember>& orbit = pieces_[number];
    const auto own = std::find_if(orbit.begin(), orbit.end(), [&](const PieceMember& member) {
      return member.edge == edge && member.t0 <= t && t <= member.t1;
    });
    if (own == orbit.end()) continue;
    const Motion back = own->motion.inverse();
    for (auto member = orbit.begin(); member != orbit.end(); ++member)
      if (member != own) images.push_back({member->edge, member->motion.after(back)});
    break;
  }
  return images;
}

std::vector<OrbitMember> Periodicity::images_on_faces(int face) const {
  std::vector<OrbitMember> images;
  if (!holds(model_face(face))) return images;
  const std::vector<OrbitMember>& orbit = faces_[orbit_of_face_[static_cast<std::size_t>(face)] - 1];
  const auto own =
      std::find_if(orbit.begin(), orbit.end(), [&](const OrbitMember& member) { return member.tag == face; });
  const Motion back = own->motion.inverse();
  for (const OrbitMember& member : orbit)
    if (member.tag != face) images.push_back({member.tag, member.motion.after(back)});
  return images;
}

PeriodicFaces faces_across(const Model& model, int axis) {
  const Facets& facets = model.facets();
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  std::vector<double> lo(static_cast<std::size_t>(model.count(2)) + 1, least), hi(lo.size(), greatest);
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    for (const Vec3& p : facet_corners(facets, t)) {
      const auto face = static_cast<std::size_t>(facets.face[t]);
      lo[face] = std::min(lo[face], p[axis]);
      hi[face] = std::max(hi[face], p[axis]);
      least = std::min(least, p[axis]);
      greatest = std::max(greatest, p[axis]);
    }
  PeriodicFaces wish;
  wish.words = std::string(1, "xyz"[axis]);
  wish.axis = axis;
  const double tolerance = kShareOfDiagonal * model.diagonal();
  for (int f = 1; f <= model.count(2); ++f) {
    const auto face = static_cast<std::size_t>(f);
    if (model.is_outside(f)) continue;
    if (hi[face] <= least + tolerance) wish.faces.push_back(f);
    if (lo[face] >= greatest - tolerance) wish.images.push_back(f);
  }
  if (wish.faces.empty() || wish.images.empty())
    refuse(wish, "no face lies in the " + std::string(wish.faces.empty() ? "least" : "greatest") +
                     " plane across " + wish.words + " that the part reaches");
  return wish;
}

}  // namespace octet

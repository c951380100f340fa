// SPDX-License-Identifier: BSD-3-Clause
// Cut along each other, told apart by winding numbers, put together again.
#include "geom/occt/unite_crossed.h"

#include <fmt/format.h>

#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.h"
#include "geom/facet_volumes.h"
#include "geom/occt/cause.h"
#include "geom/occt/crossed_loops.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/face_fuse.h"
#include "geom/occt/face_samples.h"
#include "geom/occt/pinched_faces.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/solid_model.h"
#include "geom/occt/solids_of_faces.h"
#include "geom/occt/sub_shapes.h"
#include "geom/winding.h"

namespace octet {
namespace {

using FacePairs = std::vector<std::array<TopoDS_Face, 2>>;

/// Faces that take part in a fuse.
enum class Reach { kCrossing, kNeighbours, kAll };

struct Attempt {
  Reach reach;
  double tolerance;  ///< of the fuse, as a share of the diagonal
};
constexpr std::array<Attempt, 4> kAttempts{
    {{Reach::kCrossing, 0.0}, {Reach::kCrossing, 1e-6}, {Reach::kNeighbours, 0.0}, {Reach::kAll, 0.0}}};

/// A face of the cut solid, turned so that the winding number behind it is the larger one.
struct Piece {
  TopoDS_Face face;
  int step = 0;  ///< by how much
};

/// The faces of a solid, each once. Those that it has as often one way as the other bound nothing.
std::vector<Piece> pieces_of(const TopoDS_Shape& solid) {
  TopTools_IndexedMapOfShape faces;
  std::vector<Piece> pieces;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const TopAbs_Orientation way = it.Current().Orientation();
    if (way == TopAbs_INTERNAL || way == TopAbs_EXTERNAL) continue;
    const auto index = static_cast<std::size_t>(faces.Add(it.Current()));
    if (index > pieces.size()) pieces.push_back({TopoDS::Face(it.Current()), 0});
    Piece& piece = pieces[index - 1];
    piece.step += piece.face.Orientation() == way ? 1 : -1;
  }
  for (Piece& piece : pieces)
    if (piece.step < 0) {
      piece.face.Reverse();
      piece.step = -piece.step;
    }
  std::erase_if(pieces, [](const Piece& piece) { return piece.step == 0; });
  return pieces;
}

/// Pieces that hang together over edges that only two of them use, of the same step, are all kept or all
/// dropped: for each the first such piece.
std::vector<std::size_t> sheets_of(const std::vector<Piece>& pieces) {
  TopTools_IndexedMapOfShape edges;
  std::vector<std::vector<std::size_t>> users;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (TopExp_Explorer it(pieces[i].face, TopAbs_EDGE); it.More(); it.Next()) {
      const auto edge = static_cast<std::size_t>(edges.Add(it.Current()));
      if (edge > users.size()) users.emplace_back();
      users[edge - 1].push_back(i);
    }
  std::vector<std::size_t> sheet(pieces.size());
  std::iota(sheet.begin(), sheet.end(), 0u);
  const auto root = [&](std::size_t i) {
    while (sheet[i] != i) i = sheet[i] = sheet[sheet[i]];
    return i;
  };
  for (const auto& use : users) {
    if (use.size() != 2 || pieces[use[0]].step != pieces[use[1]].step) continue;
    const auto [low, high] = std::minmax({root(use[0]), root(use[1])});
    sheet[high] = low;
  }
  for (std::size_t i = 0; i < sheet.size(); ++i) sheet[i] = root(i);
  return sheet;
}

bool closes(const std::vector<TopoDS_Shape>& solids) {
  return std::all_of(solids.begin(), solids.end(), [](const TopoDS_Shape& solid) {
    return edge_uses(solid).first(&Uses::unbalanced) == 0;
  });
}

/// Where single faces meet themselves.
Repair split_within_faces(const TopoDS_Shape& solid) {
  Repair split = split_pinched_faces(solid);
  const Repair loops = split_crossed_loops(split.solid);
  split.solid = loops.solid;
  split.history->Merge(loops.history);
  return split;
}

class Union {
 public:
  Union(const TopoDS_Shape& solid, const FacePairs& crossing, const StageLog& log)
      : solid_(solid), log_(log), split_(split_within_faces(solid)), model_(outward_model()) {
    for (const auto& pair : crossing)
      for (const TopoDS_Face& face : pair) add_parts(face);
  }

  United run() {
    United best;
    const double diagonal = diagonal_of(box_of(solid_));
    for (const auto& [reach, share] : kAttempts) {
      const TopTools_IndexedMapOfShape faces = faces_within(reach);
      log_(fmt::format("cutting {} faces of which some cross along each other", faces.Extent()));
      best = attempt(faces, share * diagonal);
      if (!best.solids.empty()) break;
    }
    return best;
  }

 private:
  /// A solid that fills all space but itself is turned.
  Model outward_model() {
    Model model = model_of_solid(split_.solid, log_);
    if (facet_volumes(model.parts())[1] >= 0.0) return model;
    split_.solid.Reverse();
    return model_of_solid(split_.solid, log_);
  }

  void add_parts(const TopoDS_Face& face) {
    const TopTools_ListOfShape& parts = split_.history->Modified(face);
    for (const TopoDS_Shape& part : parts) crossing_.Add(part.Oriented(TopAbs_FORWARD));
    if (parts.IsEmpty()) crossing_.Add(face.Oriented(TopAbs_FORWARD));
  }

  [[nodiscard]] TopTools_IndexedMapOfShape faces_within(Reach reach) const {
    if (reach == Reach::kCrossing) return crossing_;
    TopTools_IndexedMapOfShape faces = crossing_;
    TopTools_IndexedMapOfShape vertices;
    for (int i = 1; i <= crossing_.Extent(); ++i) TopExp::MapShapes(crossing_(i), TopAbs_VERTEX, vertices);
    for (TopExp_Explorer it(split_.solid, TopAbs_FACE); it.More(); it.Next()) {
      bool near = reach == Reach::kAll;
      for (TopExp_Explorer v(it.Current(), TopAbs_VERTEX); v.More() && !near; v.Next())
        near = vertices.Contains(v.Current());
      if (near) faces.Add(it.Current().Oriented(TopAbs_FORWARD));
    }
    return faces;
  }

  United attempt(const TopTools_IndexedMapOfShape& faces, double tolerance) {
    United result;
    try {
      FaceFuse fuse(faces, {}, tolerance);
      if (fuse.failed()) {
        result.cause = "OCCT cannot cut them";
        return result;
      }
      const std::vector<Piece> pieces = pieces_of(fuse.apply(split_.solid));
      const std::optional<std::vector<bool>> kept = kept_of(pieces, result.cause);
      if (!kept) return result;
      put_together(pieces, *kept, fuse, result);
    } catch (const Standard_Failure& failure) {
      result.solids.clear();
      result.cause = cause_of(failure);
    }
    return result;
  }

  /// By piece; nothing where a sheet is on different sides at different places, or nowhere clear of others.
  std::optional<std::vector<bool>> kept_of(const std::vector<Piece>& pieces, std::string& cause) const {
    const std::vector<std::size_t> sheet = sheets_of(pieces);
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < pieces.size(); ++i) members[sheet[i]].push_back(i);
    std::vector<bool> kept(pieces.size(), false);
    for (const auto& [first, all] : members) {
      const std::optional<int> outside = winding_outside(pieces, all, cause);
      if (!outside) return std::nullopt;
      for (const std::size_t i : all) kept[i] = *outside < 1 && *outside + pieces[i].step >= 1;
    }
    return kept;
  }

  [[nodiscard]] std::optional<int> winding_outside(const std::vector<Piece>& pieces,
                                                   const std::vector<std::size_t>& sheet,
                                                   std::string& cause) const {
    constexpr std::size_t kFaces = 16, kSamples = 4;
    std::optional<int> found;
    const std::size_t stride = std::max<std::size_t>(1, sheet.size() / kFaces);
    for (std::size_t i = 0; i < sheet.size() && (i / stride < kFaces || !found); i += stride) {
      const Piece& piece = pieces[sheet[i]];
      for (const FaceSample& sample : face_samples(piece.face, kSamples)) {
        const std::optional<int> here = winding_before(sample, piece.step);
        if (here && found && *here != *found) {
          cause = "a piece lies inside and outside";
          return std::nullopt;
        }
        if (here) found = here;
      }
    }
    if (!found) cause = "a piece is nowhere clear of the others";
    return found;
  }

  /// The winding number just before a face, where nothing else of the boundary is as near.
  [[nodiscard]] std::optional<int> winding_before(const FaceSample& sample, int step) const {
    constexpr std::array<double, 4> kShares{1e-4, 1e-5, 1e-6, 1e-7};
    constexpr double kMiddle = 0.1;
    std::vector<Hit> hits;
    for (const double share : kShares) {
      const Vec3 off = share * model_.diagonal() * sample.normal;
      hits.clear();
      model_.intersect(sample.point - off, sample.point + off, hits);
      const bool alone = std::all_of(hits.begin(), hits.end(),
                                     [](const Hit& hit) { return std::abs(hit.t - 0.5) < kMiddle; });
      if (hits.empty() || !alone) continue;
      const std::optional<int> before = winding_number(model_, 1, sample.point + off),
                               behind = winding_number(model_, 1, sample.point - off);
      if (before && behind && *behind == *before + step) return before;
    }
    return std::nullopt;
  }

  void put_together(const std::vector<Piece>& pieces, const std::vector<bool>& kept, const FaceFuse& fuse,
                    United& result) const {
    std::vector<TopoDS_Shape> faces;
    TopTools_MapOfShape stays;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!kept[i]) continue;
      faces.push_back(pieces[i].face);
      stays.Add(pieces[i].face);
    }
    std::vector<TopoDS_Shape> solids = solids_of_faces(faces);
    if (solids.empty() || !closes(solids)) {
      result.cause = "the pieces that are not inside do not close";
      return;
    }
    result.dropped = static_cast<int>(pieces.size() - faces.size());
    result.history = new BRepTools_History;
    result.history->Merge(split_.history);
    result.history->Merge(fuse.history());
    BRepTools_History own;
    const TopTools_IndexedMapOfShape before = sub_shapes(solid_, TopAbs_FACE);
    for (int i = 1; i <= before.Extent(); ++i) {
      TopTools_ListOfShape images = result.history->Modified(before(i));
      if (images.IsEmpty()) images.Append(before(i));
      bool any = false;
      for (const TopoDS_Shape& image : images) {
        any = any || stays.Contains(image);
        if (!stays.Contains(image) && !own.IsRemoved(image)) own.Remove(image);
      }
      if (!any) result.gone.push_back(before(i));
    }
    for (const TopoDS_Shape& solid : solids) own.AddModified(solid_, solid);
    result.history->Merge(own);
    result.solids = std::move(solids);
  }

  const TopoDS_Shape& solid_;
  const StageLog& log_;
  Repair split_;  ///< its solid is the one that is cut
  Model model_;   ///< of that
  TopTools_IndexedMapOfShape crossing_;
};

}  // namespace

United unite_crossed(const TopoDS_Shape& solid, const FacePairs& crossing, const StageLog& log) {
  United none;
  try {
    return Union(solid, crossing, log).run();
  } catch (const Standard_Failure& failure) {
    none.cause = cause_of(failure);
  } catch (const ModelError& error) {
    none.cause = error.what();
  }
  return none;
}

}  // namespace octet

// SPDX-License-Identifier: BSD-3-Clause
// The program's commands as plain requests: what main() parses and the commands run.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/size_words.h"
#include "finalize/finalize.h"
#include "geom/occt/read_part.h"

namespace octet {

struct MeshCommand {
  std::filesystem::path part, report, dump_directory;
  std::filesystem::path faults_piece;  ///< for what of the part is at fault (.brep, .step); may be empty
  std::vector<std::filesystem::path> outputs;  ///< at least one; the same mesh in each
  ReadOptions reading;                         ///< lengths in `unit`
  SizeWords sizes;                             ///< in `unit`
  std::vector<std::string> groups;             ///< NAME=PLACES; points in `unit`
  std::vector<std::string> periodic;           ///< x, y, z, PLACES=PLACES; likewise
  std::vector<std::string> layers;             ///< PLACES=HEIGHT,COUNT,GROWTH; likewise
  std::string unit;                            ///< empty: millimetre
  std::string format;                          ///< empty: by each output's suffix
  std::optional<int> threads;                  ///< none: one per core
  std::optional<double> max_elements;
  bool finalize = true;
  FinalizeScope scope = FinalizeScope::kAll;
  int order = 1;  ///< of the elements
  bool quiet = false, verbose = false;
};

struct InfoCommand {
  std::filesystem::path part;
  ReadOptions reading;  ///< lengths in `unit`
  SizeWords sizes;
  std::string unit;  ///< of lengths that it takes; empty: millimetre
  bool json = false, entities = false;
  std::vector<std::string> at;       ///< places "x,y,z": what is there, instead of the part as text
  bool show_sizes = false;           ///< the size of each entity and why, instead of the part
  std::filesystem::path size_field;  ///< VTU file to write the sizes over space into; may be empty
};

struct CheckCommand {
  std::filesystem::path mesh, part;
  ReadOptions reading;                ///< lengths in `unit`
  std::vector<std::string> periodic;  ///< as MeshCommand has it
  std::string unit;                   ///< of the mesh file's coordinates; empty: millimetre
  bool json = false;
};

struct ExtractCommand {
  std::filesystem::path part, output;
  ReadOptions reading;              ///< lengths in `unit`
  std::vector<std::string> places;  ///< parse_places(); points in `unit`
  std::string unit;                 ///< of lengths that it takes; empty: millimetre
  int around = 1;                   ///< PieceWish::around
  bool quiet = false;
};

struct QualityCommand {
  std::filesystem::path mesh;
  std::optional<double> size;   ///< asked for everywhere, in `unit`; none: the mesh's own local size
  std::filesystem::path field;  ///< or sizes over space (io/size_file.h); may be empty
  std::string unit;             ///< of the files' coordinates; empty: millimetre
  std::size_t worst = 10;
  bool json = false, csv = false;
};

struct ImproveCommand {
  std::filesystem::path mesh, part, output, report;
  ReadOptions reading;         ///< lengths in `unit`
  std::optional<double> size;  ///< wished for everywhere, in `unit`; none: as the mesh is
  std::string unit;            ///< of the mesh files' coordinates; empty: millimetre
  std::string format;          ///< empty: by the output's suffix
  std::optional<int> threads;  ///< none: one per core
  int order = 0;               ///< of the elements; 0: as they are
  bool quiet = false, verbose = false;
};

/// Each returns an ExitCode and throws what the library throws.
int run_mesh(const MeshCommand& command);
int run_info(const InfoCommand& command);
int run_check(const CheckCommand& command);
int run_extract(const ExtractCommand& command);
int run_improve(const ImproveCommand& command);
int run_quality(const QualityCommand& command);

}  // namespace octet

#include "solver/run_directory/statistics_file.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "solver/case/atomic_file.hpp"
#include "solver/run_directory/file_seal.hpp"
#include "solver/run_directory/hdf5_image.hpp"
#include "solver/run_directory/quantities.hpp"
#include "solver/run_directory/statistics_checks.hpp"

// The file is built in memory and written in one go, sealed by length and checksum (file_seal.hpp): HDF5
// never touches the disk, so a kill cannot leave half a file and a damaged file cannot crash HDF5. The price
// is that the whole file is rewritten each time; at 540 points, 18 profiles and 500 blocks that is 39 MB.
//
// Layout after the seal: attributes of / (case_id, reynolds, elastic, interface_y);
// /grid/{y_center,y_face}, /blocks/{start,end,weight}, /profiles/NAME [block][y], /series/NAME [block];
// every dataset with the text attributes unit, description, location.
namespace softwall::analysis {
namespace {

constexpr const char* kLocationAttribute = "location";

std::string location_name(Location location) { return location == Location::kCenter ? "center" : "face"; }

Location parse_location(const std::string& name, const std::string& dataset) {
  if (name == "center") return Location::kCenter;
  if (name == "face") return Location::kFace;
  throw std::runtime_error("dataset " + dataset + " has the unknown location \"" + name + "\"");
}

std::vector<hsize_t> profile_shape(const BlockStatistics& s, Location location) {
  return {s.blocks(), s.points(location)};
}

struct DatasetSpec {
  std::string name;
  std::string location;  ///< "center", "face" or "block"
  std::vector<hsize_t> shape;
};

void write_described(const Hdf5Id& group, const BlockStatistics& s, const DatasetSpec& spec,
                     const std::vector<double>& values) {
  const Hdf5Id dataset = write_dataset(group.get(), spec.name, values, spec.shape);
  const Meaning* meaning = meaning_of(s, spec.name);  // never null: mistakes() was asked first
  write_attribute(dataset.get(), "unit", meaning->unit);
  write_attribute(dataset.get(), "description", meaning->description);
  write_attribute(dataset.get(), kLocationAttribute, spec.location);
}

std::string to_image(const BlockStatistics& s) {
  const Hdf5Id file = create_image();
  write_attribute(file.get(), "case_id", s.case_id);
  write_attribute(file.get(), "reynolds", s.reynolds);
  write_attribute(file.get(), "elastic", s.elastic ? 1.0 : 0.0);
  write_attribute(file.get(), "interface_y", s.interface_y);
  const Hdf5Id grid = create_group(file.get(), "grid");
  write_described(grid, s, {"y_center", "center", {s.y_center.size()}}, s.y_center);
  write_described(grid, s, {"y_face", "face", {s.y_face.size()}}, s.y_face);
  const Hdf5Id blocks = create_group(file.get(), "blocks");
  write_described(blocks, s, {"start", "block", {s.blocks()}}, s.start);
  write_described(blocks, s, {"end", "block", {s.blocks()}}, s.end);
  write_described(blocks, s, {"weight", "block", {s.blocks()}}, s.weight);
  const Hdf5Id profiles = create_group(file.get(), "profiles");
  for (const auto& [name, profile] : s.profiles) {
    write_described(profiles, s, {name, location_name(profile.location), profile_shape(s, profile.location)},
                    profile.values);
  }
  const Hdf5Id series = create_group(file.get(), "series");
  for (const auto& [name, values] : s.series)
    write_described(series, s, {name, "block", {s.blocks()}}, values);
  return image_bytes(file);
}

std::vector<double> read_line(const Hdf5Id& group, const std::string& name) {
  const Hdf5Id dataset = open_dataset(group.get(), name);
  return read_dataset(dataset.get(), name, {dataset_length(dataset.get(), name)});
}

/// Keep a name's own meaning only where it differs from the known one, so that reading undoes writing.
void keep_meaning(BlockStatistics& s, const Hdf5Id& dataset, const std::string& name) {
  const Meaning meaning{read_text_attribute(dataset.get(), "unit"),
                        read_text_attribute(dataset.get(), "description")};
  const Meaning* known = known_meaning(name);
  if (known == nullptr || known->unit != meaning.unit || known->description != meaning.description) {
    s.meanings[name] = meaning;
  }
}

BlockStatistics from_image(std::string_view bytes) {
  const Hdf5Id file = open_image(bytes);
  BlockStatistics s;
  s.case_id = read_text_attribute(file.get(), "case_id");
  s.reynolds = read_number_attribute(file.get(), "reynolds");
  s.elastic = read_number_attribute(file.get(), "elastic") != 0.0;
  s.interface_y = read_number_attribute(file.get(), "interface_y");
  const Hdf5Id grid = open_group(file.get(), "grid");
  s.y_center = read_line(grid, "y_center");
  s.y_face = read_line(grid, "y_face");
  const Hdf5Id blocks = open_group(file.get(), "blocks");
  s.start = read_line(blocks, "start");
  s.end = read_line(blocks, "end");
  s.weight = read_line(blocks, "weight");
  const Hdf5Id profiles = open_group(file.get(), "profiles");
  for (const std::string& name : member_names(profiles.get())) {
    const Hdf5Id dataset = open_dataset(profiles.get(), name);
    const Location location = parse_location(read_text_attribute(dataset.get(), kLocationAttribute), name);
    s.profiles[name] = {location, read_dataset(dataset.get(), name, profile_shape(s, location))};
    keep_meaning(s, dataset, name);
  }
  const Hdf5Id series = open_group(file.get(), "series");
  for (const std::string& name : member_names(series.get())) {
    const Hdf5Id dataset = open_dataset(series.get(), name);
    s.series[name] = read_dataset(dataset.get(), name, {s.blocks()});
    keep_meaning(s, dataset, name);
  }
  return s;
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

void refuse_mistakes(const BlockStatistics& s) {
  if (const auto found = mistakes(s); !found.empty())
    throw std::runtime_error("is inconsistent: " + joined(found));
}

std::string file_contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot be opened");
  std::string contents{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) throw std::runtime_error("cannot be read");
  return contents;
}

}  // namespace

void write_statistics(const std::filesystem::path& path, const BlockStatistics& statistics) {
  std::string sealed;
  try {
    const QuietHdf5 quiet;
    refuse_mistakes(statistics);
    const std::string image = to_image(statistics);
    sealed = seal_for(image) + image;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("statistics for " + path.string() + ": " + error.what());
  }
  write_atomically(path, sealed);
}

BlockStatistics read_statistics(const std::filesystem::path& path) {
  try {
    const QuietHdf5 quiet;
    const std::string file = file_contents(path);
    BlockStatistics statistics = from_image(open_seal(file));
    refuse_mistakes(statistics);
    return statistics;
  } catch (const std::exception& error) {  // also bad_alloc and length_error from a nonsensical size
    throw std::runtime_error(path.string() + " " + error.what());
  }
}

}  // namespace softwall::analysis

#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>

/// Words of XDMF, the text that tells ParaView what the numbers in an HDF5 file mean.
namespace softwall::output {

/// The file of one moment as XDMF names it: without its folder, which is that of the collection.
struct XdmfSource {
  std::string file;

  /// Where the numbers of a dataset stand. extents: slowest first, with blanks between; bytes: of one number.
  [[nodiscard]] std::string item(const std::string& dataset, const std::string& extents,
                                 std::size_t bytes) const {
    return "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"" + std::to_string(bytes) +
           "\" Dimensions=\"" + extents + "\">" + file + ":/" + dataset + "</DataItem>";
  }

  /// A quantity. kind: Scalar, Vector, Tensor6; center: Cell or Node, where its numbers stand.
  [[nodiscard]] static std::string attribute(const std::string& name, const std::string& kind,
                                             const std::string& center, const std::string& data) {
    return "<Attribute Name=\"" + name + "\" AttributeType=\"" + kind + "\" Center=\"" + center + "\">" +
           data + "</Attribute>\n";
  }
};

}  // namespace softwall::output

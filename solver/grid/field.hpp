#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "solver/grid/grid.hpp"

/// Memory for one number in every cell, and views into it.
namespace softwall::grid {

/// A window on somebody's memory, indexed by cell, i contiguous. Never owns.
template <class T>
struct View {
  T* origin = nullptr;  ///< address of cell (0, 0, 0)
  std::ptrdiff_t stride_y = 0, stride_z = 0;
  T& operator()(int i, int j, int k) const { return origin[i + j * stride_y + k * stride_z]; }
};

/// How a field lies in memory, in huge pages where possible: plane by plane, got all at once; or height by
/// height, got as it is touched, so that a solid's fields may span the whole height and cost what its own
/// rows do.
enum class Memory { kByPlane, kByHeight };

/// Owner of nx x ny x nz numbers with `ghost` layers on every side, zero at first.
class Field {
 public:
  Field() = default;
  Field(const Grid& g, int ghost, Memory memory = Memory::kByHeight);

  Real& operator()(int i, int j, int k) { return view()(i, j, k); }
  Real operator()(int i, int j, int k) const { return view()(i, j, k); }
  [[nodiscard]] View<Real> view() { return {origin(), stride_y_, stride_z_}; }
  [[nodiscard]] View<const Real> view() const { return {origin(), stride_y_, stride_z_}; }

  [[nodiscard]] int nx() const { return nx_; }
  [[nodiscard]] int ny() const { return ny_; }
  [[nodiscard]] int nz() const { return nz_; }
  [[nodiscard]] int ghost() const { return ghost_; }

 private:
  struct Free {
    void operator()(Real* p) const;
  };
  [[nodiscard]] Real* origin() const { return memory_.get() + offset_; }

  int nx_ = 0, ny_ = 0, nz_ = 0, ghost_ = 0;
  std::ptrdiff_t stride_y_ = 0, stride_z_ = 0;
  std::ptrdiff_t offset_ = 0;  ///< of cell (0, 0, 0)
  std::unique_ptr<Real[], Free> memory_;
};

/// Three components on the faces (velocity, force) or anywhere else.
struct VectorField {
  Field x, y, z;
  VectorField() = default;
  VectorField(const Grid& g, int ghost, Memory memory = Memory::kByHeight)
      : x(g, ghost, memory), y(g, ghost, memory), z(g, ghost, memory) {}
};

/// A vector field of so many planes, without ghost layers, plane by plane in memory.
[[nodiscard]] inline VectorField some_planes(Grid g, int planes) {
  g.nz = planes;
  return {g, 0, Memory::kByPlane};
}

/// Six components of a symmetric tensor: normal ones at centers, shear ones on edges.
struct TensorField {
  Field xx, yy, zz, xy, xz, yz;
  TensorField() = default;
  TensorField(const Grid& g, int ghost)
      : xx(g, ghost), yy(g, ghost), zz(g, ghost), xy(g, ghost), xz(g, ghost), yz(g, ghost) {}
};

}  // namespace softwall::grid

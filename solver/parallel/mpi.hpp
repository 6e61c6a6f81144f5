#pragma once

#include <mpi.h>

#include <complex>
#include <stdexcept>
#include <string>
#include <utility>

/// Owners and checked calls for MPI.
namespace softwall::parallel {

/// Throws std::runtime_error with MPI's own text when a call fails.
inline void check(int code, const char* what) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw std::runtime_error(std::string(what) + ": " + std::string(text, static_cast<std::size_t>(length)));
}

/// MPI_Init and MPI_Finalize as one scope of main().
class Session {
 public:
  Session(int* argc, char*** argv) { check(MPI_Init(argc, argv), "MPI_Init"); }
  ~Session() { MPI_Finalize(); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

/// A communicator that is freed with its owner.
class Communicator {
 public:
  Communicator() = default;
  explicit Communicator(MPI_Comm owned) : comm_(owned) {}
  Communicator(Communicator&& other) noexcept : comm_(std::exchange(other.comm_, MPI_COMM_NULL)) {}
  Communicator& operator=(Communicator&& other) noexcept {
    std::swap(comm_, other.comm_);
    return *this;
  }
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  ~Communicator() {
    if (comm_ != MPI_COMM_NULL) MPI_Comm_free(&comm_);
  }

  /// A private copy of `comm`, so that the library's messages never meet the caller's.
  static Communicator duplicate(MPI_Comm comm) {
    MPI_Comm copy = MPI_COMM_NULL;
    check(MPI_Comm_dup(comm, &copy), "MPI_Comm_dup");
    return Communicator(copy);
  }
  /// The ranks of `comm` with the same colour, ordered by key.
  static Communicator split(MPI_Comm comm, int color, int key) {
    MPI_Comm part = MPI_COMM_NULL;
    check(MPI_Comm_split(comm, color, key, &part), "MPI_Comm_split");
    return Communicator(part);
  }

  [[nodiscard]] MPI_Comm get() const { return comm_; }
  [[nodiscard]] int rank() const {
    int r = 0;
    check(MPI_Comm_rank(comm_, &r), "MPI_Comm_rank");
    return r;
  }
  [[nodiscard]] int size() const {
    int n = 0;
    check(MPI_Comm_size(comm_, &n), "MPI_Comm_size");
    return n;
  }

 private:
  MPI_Comm comm_ = MPI_COMM_NULL;
};

template <class T>
MPI_Datatype mpi_type();
template <>
inline MPI_Datatype mpi_type<double>() {
  return MPI_DOUBLE;
}
template <>
inline MPI_Datatype mpi_type<float>() {
  return MPI_FLOAT;
}
template <>
inline MPI_Datatype mpi_type<std::complex<double>>() {
  return MPI_C_DOUBLE_COMPLEX;
}
template <>
inline MPI_Datatype mpi_type<std::complex<float>>() {
  return MPI_C_FLOAT_COMPLEX;
}

}  // namespace softwall::parallel

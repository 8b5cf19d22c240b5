/// The door to HDF5's C interface: owned handles and checked calls, nothing else.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include <hdf5.h>

namespace overturn::store {

/// Owns one HDF5 identifier and closes it.
template <auto Close> class Handle {
  public:
    Handle() = default;
    explicit Handle(hid_t id) : id_(id) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    Handle(Handle const&) = delete;
    Handle& operator=(Handle const&) = delete;
    ~Handle() {
        if (id_ >= 0) {
            Close(id_);
        }
    }
    [[nodiscard]] hid_t id() const { return id_; }
    /// Gives the identifier up unclosed.
    hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

  private:
    hid_t id_ = H5I_INVALID_HID;
};

using File = Handle<H5Fclose>;
using Group = Handle<H5Gclose>;
using Dataset = Handle<H5Dclose>;
using Dataspace = Handle<H5Sclose>;
using Datatype = Handle<H5Tclose>;
using Attribute = Handle<H5Aclose>;
using PropertyList = Handle<H5Pclose>;

/// The result of an HDF5 call, or SystemError saying what was tried and HDF5's own innermost reason.
template <class Result> Result checked(Result result, std::string const& what);

/// Is there memory enough for HDF5 to work in? It frees twice where it gets none (1.10, amid the copy of a property
/// list and others), and what a heap does after that is anyone's guess: it aborts, or waits for ever.
/// \throws std::bad_alloc
void require_memory_for_hdf5();

/// Silences HDF5's own error printing for as long as it lives; `checked` reports instead. The first one also keeps HDF5
/// from cleaning up at exit, where it crashes over a file that could not be written.
class Quiet {
  public:
    Quiet();
    ~Quiet();
    Quiet(Quiet const&) = delete;
    Quiet& operator=(Quiet const&) = delete;
    Quiet(Quiet&&) = delete;
    Quiet& operator=(Quiet&&) = delete;

  private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

void write_attribute(hid_t where, std::string const& name, std::string const& text);
void write_attribute(hid_t where, std::string const& name, std::int64_t value);
void write_attribute(hid_t where, std::string const& name, double value);

[[nodiscard]] std::string read_text_attribute(hid_t where, std::string const& name);
[[nodiscard]] std::int64_t read_integer_attribute(hid_t where, std::string const& name);

}  // namespace overturn::store

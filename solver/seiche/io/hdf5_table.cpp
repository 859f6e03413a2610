#include "seiche/io/hdf5_table.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <set>
#include <stdexcept>
#include <string_view>

#include <H5Cpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "seiche/io/atomic_file.hpp"
#include "seiche/require_that.hpp"
#include "seiche/wording.hpp"

namespace seiche::io {
namespace {

constexpr hsize_t longest_file = 50'000'000;  // [number], in all datasets that are read; kilobytes may declare more
constexpr std::size_t most_datasets = 1000;

/// Numbers or a text as bytes and back, to pass them from one process to the other.
template <class Sequence>
void put(std::string& bytes, const Sequence& items) {
  const std::size_t count = items.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(items.data()), count * sizeof items[0]);
}

template <class Sequence>
Sequence take(std::string_view& bytes) {
  const auto cut = [&](void* target, std::size_t count, std::size_t size) {
    require_that(count <= bytes.size() / size, "incomplete answer");
    std::copy_n(bytes.data(), count * size, static_cast<char*>(target));
    bytes.remove_prefix(count * size);
  };
  constexpr std::size_t size = sizeof(typename Sequence::value_type);
  std::size_t count = 0;
  cut(&count, 1, sizeof count);
  require_that(count <= bytes.size() / size, "incomplete answer");
  Sequence sequence(count, {});
  cut(sequence.data(), count, size);
  return sequence;
}

/// Names and reasons come from the file: whatever is no text must not reach the terminal.
std::string one_line(const std::string& text) {
  return printable(text.substr(0, 200));
}

/// Called by HDF5 for each object or link: notes the names of those of a kind.
template <class Info, auto kind>
herr_t note(hid_t /*root*/, const char* name, const Info* info, void* names) {
  auto& known = *static_cast<std::vector<std::string>*>(names);
  if (info->type == kind) known.emplace_back(name);
  return known.size() < most_datasets ? 0 : 1;
}

/// @throws std::invalid_argument when the file cannot be walked through
std::vector<std::string> dataset_names(const H5::H5File& file) {
  std::vector<std::string> names;
  require_that(H5Ovisit(file.getId(), H5_INDEX_NAME, H5_ITER_INC, note<H5O_info_t, H5O_TYPE_DATASET>, &names) >= 0,
               "damaged: its datasets cannot be listed");
  return names;
}

std::string unit_of(const H5::DataSet& set) {
  for (const char* name : {"unit", "units"}) {
    if (!set.attrExists(name)) continue;
    const H5::Attribute attribute = set.openAttribute(name);
    require_that(attribute.getTypeClass() == H5T_STRING && attribute.getSpace().getSimpleExtentNpoints() == 1,
                 "its attribute {} is not a text", name);
    std::string text;
    attribute.read(attribute.getStrType(), text);
    const std::size_t begin = text.find_first_not_of(" \t");
    text = text.substr(0, text.find('\0'));
    return begin >= text.size() ? "" : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
  }
  return {};
}

/// A number with which netCDF says what is stored.
double attribute_of(const H5::DataSet& set, const char* name, double otherwise) {
  if (!set.attrExists(name)) return otherwise;
  const H5::Attribute attribute = set.openAttribute(name);
  const H5T_class_t kind = attribute.getTypeClass();
  require_that((kind == H5T_FLOAT || kind == H5T_INTEGER) && attribute.getSpace().getSimpleExtentNpoints() == 1,
               "its attribute {} is not a number", name);
  double value = otherwise;
  attribute.read(H5::PredType::NATIVE_DOUBLE, &value);
  return value;
}

/// @throws std::invalid_argument where the numbers lie in another file, which may be anybody's
void require_own_storage(const H5::DataSet& set) {
  const H5::DSetCreatPropList properties = set.getCreatePlist();
  const H5D_layout_t layout = properties.getLayout();
  require_that(layout != H5D_VIRTUAL && (layout != H5D_CONTIGUOUS || properties.getExternalCount() == 0),
               "its numbers lie in another file, must be in this one");
}

/// @param most_elements  left of those that the file may have
/// @throws std::invalid_argument with the reason why the dataset is no column
std::vector<double> values_of(const H5::DataSet& set, hsize_t most_elements) {
  const H5T_class_t kind = set.getTypeClass();
  require_that(kind == H5T_FLOAT || kind == H5T_INTEGER, "its elements are not numbers");
  const H5::DataSpace space = set.getSpace();
  std::array<hsize_t, H5S_MAX_RANK> extents{};
  const int dimensions = space.isSimple() ? space.getSimpleExtentDims(extents.data()) : 0;
  if (!space.isSimple() ||
      std::count_if(extents.begin(), extents.begin() + dimensions, [](hsize_t n) { return n > 1; }) > 1) {
    throw std::invalid_argument(fmt::format("has {} dimensions, must have one", dimensions));
  }
  require_own_storage(set);
  const auto count = static_cast<hsize_t>(space.getSimpleExtentNpoints());
  require_that(count <= most_elements, "{} elements with those before it, must be at most {}",
               count + longest_file - most_elements, longest_file);
  std::vector<double> values(count);
  if (count > 0) set.read(values.data(), H5::PredType::NATIVE_DOUBLE);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const double fill = attribute_of(set, "_FillValue", none);
  const double missing = attribute_of(set, "missing_value", none);
  const double factor = attribute_of(set, "scale_factor", 1);
  const double offset = attribute_of(set, "add_offset", 0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    require_that(!std::isinf(values[k]), "element {}: '{}' is not a finite number", k, values[k]);
    values[k] = values[k] == fill || values[k] == missing ? none : factor * values[k] + offset;
  }
  return values;
}

/// Per dataset: name, reason why it is unusable or nothing, unit, values.
std::string datasets(const std::filesystem::path& path, const std::vector<std::string>& wanted) {
  H5::Exception::dontPrint();
  std::string bytes;
  const auto put_dataset = [&](const std::string& name, const std::string& reason, const std::string& unit,
                               const std::vector<double>& values) {
    for (const std::string& text : {name, reason, unit}) put(bytes, one_line(text));
    put(bytes, values);
  };
  try {
    const H5::H5File file(path.string(), H5F_ACC_RDONLY);
    const std::vector<std::string> names = dataset_names(file);
    const std::set<std::string> needed(wanted.begin(), wanted.end());
    hsize_t numbers = 0;
    for (const std::string& name : names) {
      std::string reason;
      std::string unit;
      std::vector<double> values;
      if (!needed.empty() && needed.count(name) == 0) {
        reason = "not asked for";
      } else {
        try {
          const H5::DataSet set = file.openDataSet(name);
          unit = unit_of(set);
          values = values_of(set, longest_file - numbers);
          numbers += values.size();
        } catch (const std::invalid_argument& unusable) {
          reason = unusable.what();
        } catch (const H5::Exception&) {
          reason = "damaged: cannot be read";
        }
      }
      put_dataset(name, reason, unit, values);
    }
    std::vector<std::string> links;  // which H5Ovisit does not follow
    H5Lvisit(file.getId(), H5_INDEX_NAME, H5_ITER_INC, note<H5L_info_t, H5L_TYPE_EXTERNAL>, &links);
    for (const std::string& name : links) put_dataset(name, "a link to another file, must be in this one", "", {});
  } catch (const H5::Exception&) {
    throw std::invalid_argument("damaged: the HDF5 library cannot open it");
  }
  return bytes;
}

Table table_from(std::string_view bytes, const std::string& source) {
  Table table;
  table.source = source;
  while (!bytes.empty()) {
    const auto name = take<std::string>(bytes);
    const auto reason = take<std::string>(bytes);
    auto unit = take<std::string>(bytes);
    auto values = take<std::vector<double>>(bytes);
    if (!reason.empty()) {
      table.unusable[name] = reason;
    } else if (!table.has(name)) {
      table.names.push_back(name);
      table.units.push_back(std::move(unit));
      table.columns.push_back(std::move(values));
    }
  }
  return table;
}

constexpr char returned = 'r';
constexpr char threw = 't';

void limit(__rlimit_resource resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

void send(int pipe, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = write(pipe, text.data() + sent, text.size() - sent);
    if (count < 0 && errno != EINTR) leave(1);
    if (count > 0) sent += static_cast<std::size_t>(count);
  }
}

std::string receive(int pipe) {
  std::string text;
  std::array<char, 1 << 16> buffer{};
  for (ssize_t count = 0; (count = read(pipe, buffer.data(), buffer.size())) != 0;) {
    if (count < 0 && errno != EINTR) break;
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

[[noreturn]] void live(const std::function<std::string()>& action, unsigned seconds, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // whose shadow memory is larger than any limit
  limit(RLIMIT_AS, rlim_t{4} << 30);
#endif
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(crash, SIG_DFL);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  std::string answer;
  try {
    answer = returned + action();
  } catch (const std::exception& failure) {
    answer = threw + std::string(failure.what());
  }
  send(pipe, answer);
  leave(0);
}

}  // namespace

bool is_hdf5(const std::filesystem::path& file) {
  std::error_code failure;
  H5::Exception::dontPrint();
  return std::filesystem::is_regular_file(file, failure) && H5Fis_hdf5(file.c_str()) > 0;
}

bool has_checksums(const std::filesystem::path& file) {
  const auto all_have = [&]() -> std::string {
    H5::Exception::dontPrint();
    try {
      const H5::H5File opened(file.string(), H5F_ACC_RDONLY);
      for (const std::string& name : dataset_names(opened)) {
        const H5::DataSet set = opened.openDataSet(name);
        unsigned flags = 0;
        unsigned config = 0;
        std::size_t values = 0;
        const H5::DSetCreatPropList properties = set.getCreatePlist();
        const bool none = H5Pget_filter_by_id2(properties.getId(), H5Z_FILTER_FLETCHER32, &flags, &values, nullptr, 0,
                                               nullptr, &config) < 0;
        if (none && set.getStorageSize() > 0) return "no";
      }
    } catch (const H5::Exception&) {
      return "no";
    }
    return "yes";
  };
  try {
    return isolated(all_have, 10) == "yes";
  } catch (const std::exception&) {
    return false;
  }
}

Table read_hdf5(const std::filesystem::path& file, const std::vector<std::string>& wanted, unsigned seconds) {
  try {
    return table_from(isolated([&] { return datasets(file, wanted); }, seconds), file.string());
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(fmt::format("{}: {}", file.string(), wrong.what()));
  } catch (const std::runtime_error& broken) {
    throw std::invalid_argument(fmt::format("{}: damaged or too large: {}", file.string(), broken.what()));
  }
}

std::string isolated(const std::function<std::string()>& action, unsigned seconds) {
  std::array<int, 2> ends{};
  require_that<std::runtime_error>(pipe2(ends.data(), O_CLOEXEC) == 0, "cannot make a pipe for a child process");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    live(action, seconds, ends[1]);
  }
  const int fork_error = errno;
  close(ends[1]);
  const std::string answer = child > 0 ? receive(ends[0]) : "";
  close(ends[0]);
  require_that<std::runtime_error>(child >= 0, "cannot start a child process: {}", std::strerror(fork_error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const bool too_long = signal == SIGXCPU || signal == SIGKILL;
    throw std::runtime_error(too_long ? fmt::format("the child process did not end within {} s", seconds)
                                      : fmt::format("the child process crashed by signal {}", signal));
  }
  require_that<std::runtime_error>(status == 0 && !answer.empty(), "the child process crashed without an answer");
  if (answer.front() == threw) throw std::invalid_argument(answer.substr(1));
  return answer.substr(1);
}

}  // namespace seiche::io

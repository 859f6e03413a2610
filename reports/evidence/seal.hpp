/// What holds the files of a record together: its JSON ends with the digest of all that stands before it, and among
/// that are the digests of the files beside it.
#pragma once

#include <string>
#include <string_view>

namespace seiche::evidence {

/// Puts the digest at the end of a record's text: `{...}\n` becomes `{..., "digest": "<SHA-256>"}\n`. The digest is
/// that of all bytes before its own first digit.
/// @param text  a JSON object that ends with "\n}\n" and has no digest
std::string sealed(std::string text);

/// Whether a text ends with the digest of what stands before it.
bool is_sealed(std::string_view text);

}  // namespace seiche::evidence

// SPDX-License-Identifier: MIT
#include "reprise/reprise.hpp"

static_assert(!std::is_copy_constructible_v<reprise::OwnedContext>);

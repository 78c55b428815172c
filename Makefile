# Builds the C library with Cargo, and installs what was built.
#
#   make               builds libcritreg.a and, for Linux, libcritreg.so
#   make install       copies them, the headers, files for pkg-config, CMake and ROS 2, and
#                      the licences below PREFIX; needs neither Rust nor a compiler
#   make uninstall     removes what make install copied
#   make doc           a site of the C and C++ interface, in target/doxygen/html; needs Doxygen
#
#   PREFIX, LIBDIR, INCLUDEDIR   where to; /usr/local, and lib and include in it
#   DESTDIR                      a root in front of all of them, for packagers
#   CARGO_BUILD_TARGET           the target triple to build for, or to install
#   CARGO_TARGET_DIR             Cargo's directory, if it is not target
#   CRITREG_FEATURES             what to build; see ffi/README.md
#   STRIP                        takes symbols out of a library of the target

CARGO ?= cargo
INSTALL ?= install
PREFIX ?= /usr/local
LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
CRITREG_FEATURES ?= default
# Tools of another target have its name in front, as in aarch64-linux-gnu-strip.
STRIP ?= $(if $(CARGO_BUILD_TARGET),$(subst -unknown,,$(CARGO_BUILD_TARGET))-)strip

ifneq ($(filter-out /%,$(PREFIX) $(LIBDIR) $(INCLUDEDIR)),)
$(error PREFIX, LIBDIR and INCLUDEDIR must be absolute paths without blanks)
endif

VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
ABI := $(shell sed -n 's/^\#define CRITREG_ABI_VERSION //p' include/critreg.h)
HEADERS := $(wildcard include/*.h include/*.hpp)
LICENCES := LICENSE-MIT LICENSE-APACHE ffi/package/THIRD_PARTY

# Where Cargo builds, and where the libraries lie under the names that C knows them by.
TARGET := $(abspath $(or $(CARGO_TARGET_DIR),target))
BUILT := $(TARGET)/$(if $(CARGO_BUILD_TARGET),$(CARGO_BUILD_TARGET)/)
LIBRARIES := $(BUILT)c

# The chain of names of a shared library: to link with, to load, and the file itself.
LINKED := libcritreg.so
LOADED := $(LINKED).$(ABI)
SHARED := $(LINKED).$(VERSION)
ifneq ($(findstring linux,$(or $(CARGO_BUILD_TARGET),$(shell uname | tr A-Z a-z))),)
# It needs memcpy() and the like, and is loaded by a name of its own.
LINK_ARGS := -C link-arg=-lc -C link-arg=-Wl,-soname,$(LOADED)
endif

library:
	$(CARGO) rustc --quiet --release --package critreg-ffi --no-default-features \
		--features "halt $(CRITREG_FEATURES)" --crate-type staticlib,cdylib \
		--target-dir $(TARGET) -- $(LINK_ARGS)
	@mkdir -p $(LIBRARIES)
	@# Cargo knows best whether a library is up to date; one that did not change is not
	@# copied, so that programs are not linked again for nothing.
	@cmp -s $(BUILT)release/libcritreg_ffi.a $(LIBRARIES)/libcritreg.a \
		|| cp $(BUILT)release/libcritreg_ffi.a $(LIBRARIES)/libcritreg.a
	@if test -n "$(LINK_ARGS)" && test -f $(BUILT)release/libcritreg_ffi.so; then \
		cp $(BUILT)release/libcritreg_ffi.so $(LIBRARIES)/$(SHARED); \
		ln -sf $(SHARED) $(LIBRARIES)/$(LOADED); \
		ln -sf $(LOADED) $(LIBRARIES)/$(LINKED); \
	fi

# Each file below PREFIX once, as make install makes it and make uninstall removes it.
CMAKE_DIR := $(LIBDIR)/cmake/critreg
SHARE := $(PREFIX)/share/critreg
DOC := $(PREFIX)/share/doc/critreg
INSTALLED := $(addprefix $(INCLUDEDIR)/,$(notdir $(HEADERS))) \
	$(addprefix $(LIBDIR)/,libcritreg.a $(SHARED) $(LOADED) $(LINKED) pkgconfig/critreg.pc) \
	$(CMAKE_DIR)/critregConfig.cmake $(CMAKE_DIR)/critregConfigVersion.cmake \
	$(SHARE)/package.xml $(addprefix $(DOC)/,$(notdir $(LICENCES)))

# A directory below PREFIX is told relative to it, so that what is installed can be moved;
# to CMake, which knows where its file lies, by the way up from LIBDIR.
below_prefix = $(patsubst $(PREFIX)/%,$(1)/%,$(2))
EMPTY :=
UP := $(subst $(EMPTY) $(EMPTY),/,$(patsubst %,..,$(subst /, ,$(LIBDIR:$(PREFIX)/%=%))))
FROM_LIBDIR := $(if $(filter $(PREFIX)/%,$(LIBDIR)),$${_critreg_libdir}/$(UP),$(PREFIX))
FILL := sed -e 's|@PREFIX@|$(PREFIX)|g' \
	-e 's|@LIBDIR@|$(call below_prefix,$${prefix},$(LIBDIR))|g' \
	-e 's|@INCLUDEDIR@|$(call below_prefix,$${prefix},$(INCLUDEDIR))|g' \
	-e 's|@CMAKE_INCLUDEDIR@|$(call below_prefix,$(FROM_LIBDIR),$(INCLUDEDIR))|g' \
	-e 's|@VERSION@|$(VERSION)|g' -e 's|@SHARED@|$(SHARED)|g' -e 's|@LOADED@|$(LOADED)|g'

install:
	@test -f $(LIBRARIES)/libcritreg.a || { echo "there is no library in $(LIBRARIES):" \
		"run make first, with the same CARGO_BUILD_TARGET and CARGO_TARGET_DIR" >&2; exit 1; }
	$(INSTALL) -d $(addprefix $(DESTDIR),$(sort $(dir $(INSTALLED))))
	$(INSTALL) -m 644 $(HEADERS) $(DESTDIR)$(INCLUDEDIR)
	$(INSTALL) -m 644 $(LIBRARIES)/libcritreg.a $(DESTDIR)$(LIBDIR)
	$(STRIP) --strip-debug $(DESTDIR)$(LIBDIR)/libcritreg.a
	if test -f $(LIBRARIES)/$(SHARED); then \
		$(INSTALL) -m 755 $(LIBRARIES)/$(SHARED) $(DESTDIR)$(LIBDIR) \
		&& $(STRIP) --strip-unneeded $(DESTDIR)$(LIBDIR)/$(SHARED) \
		&& ln -sf $(SHARED) $(DESTDIR)$(LIBDIR)/$(LOADED) \
		&& ln -sf $(LOADED) $(DESTDIR)$(LIBDIR)/$(LINKED); \
	fi
	$(FILL) ffi/package/critreg.pc.in >$(DESTDIR)$(LIBDIR)/pkgconfig/critreg.pc
	$(FILL) ffi/package/critregConfig.cmake.in >$(DESTDIR)$(CMAKE_DIR)/critregConfig.cmake
	$(FILL) ffi/package/critregConfigVersion.cmake.in \
		>$(DESTDIR)$(CMAKE_DIR)/critregConfigVersion.cmake
	$(INSTALL) -m 644 ffi/package/package.xml $(DESTDIR)$(SHARE)
	$(INSTALL) -m 644 $(LICENCES) $(DESTDIR)$(DOC)

# Directories that critreg has for itself go, too.
uninstall:
	rm -f $(addprefix $(DESTDIR),$(INSTALLED))
	for own in $(CMAKE_DIR) $(SHARE) $(DOC); do \
		rmdir $(DESTDIR)$$own 2>/dev/null || true; \
	done

doc:
	@mkdir -p target/doxygen
	doxygen include/Doxyfile

.PHONY: library install uninstall doc
.DELETE_ON_ERROR:

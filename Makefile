# On a fresh Debian 12 every target works without preparation.

SHELL := /bin/bash
# catkin and the ROS tools break if another python3 (pyenv, conda) comes first on PATH.
export PATH := /usr/bin:$(PATH)
export ROS_LANG_DISABLE := genlisp:geneus:gennodejs
JOBS ?= $(shell nproc)
# rostests side by side in make test; a simulated cell counts as two
CELLS ?= $(shell echo $$((2 * $(JOBS))))
# of each reader, in make fuzz
RUNS ?= 2000000
# build trees and flags; make sanitize uses its own
BUILD ?= build
DEVEL ?= devel
FLAGS ?= -O2 -g1 -DNDEBUG
# sources that are compiled as one; 1 compiles each alone
BATCH ?= 8
# Without the first it does not look at sources that use precompiled headers; the others let checkouts share it.
CCACHE = env;CCACHE_SLOPPINESS=pch_defines,time_macros;CCACHE_BASEDIR=$(CURDIR);CCACHE_NOHASHDIR=1;$(or $(shell command -v ccache),/usr/bin/ccache)
IN_WORKSPACE = source $(DEVEL)/setup.bash &&

.PHONY: all build demo test bench fuzz trials soak sanitize film install lint docs format clean dependencies configure

all: build

dependencies:
	@scripts/install_dependencies.sh packages.txt

src/CMakeLists.txt:
	@ln -s /usr/share/catkin/cmake/toplevel.cmake $@

# -g1 keeps the lines in stack traces and takes a quarter less compile time than -g.
configure: dependencies src/CMakeLists.txt
	@scripts/configure.sh $(BUILD) $(DEVEL) -DCMAKE_INSTALL_PREFIX=$(CURDIR)/install \
	  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO='$(FLAGS)' \
	  -DSCAN_CELL_BATCH=$(BATCH) -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
	  -DCMAKE_CXX_COMPILER_LAUNCHER='$(CCACHE)'

build: configure
	@cmake --build $(BUILD) --parallel $(JOBS)

# rviz opens only on a screen
demo: configure
	@cmake --build $(BUILD) --parallel $(JOBS) --target first_steps $(if $(DISPLAY),scan_cell_rviz_panel)
	@scripts/demo.sh

bench: build
	@cmake --build $(BUILD) --parallel $(JOBS) --target benchmarks
	@$(IN_WORKSPACE) for bench in $(DEVEL)/lib/*/bench_*; do echo "== $$(basename $$bench)"; $$bench || exit 1; done

fuzz: build
	@cmake --build $(BUILD) --parallel $(JOBS) --target fuzzers
	@$(IN_WORKSPACE) for fuzzer in $(DEVEL)/lib/*/fuzz_*; do $$fuzzer --runs $(RUNS) || exit 1; done

test: build
	@scripts/install_dependencies.sh packages_for_tests.txt
	@cmake --build $(BUILD) --parallel $(JOBS) --target tests
	@$(IN_WORKSPACE) scripts/run_tests.sh $(BUILD) $(JOBS) $(CELLS)

# COUNT times emergency stop, cable pulled, controller, driver, cell or ViDeE's node killed, during moves and scans
trials: build
	@$(IN_WORKSPACE) rosrun scan_cell_demo trials --count $(or $(COUNT),200)

# HOURS of scanning with faults on the wires: does any node leak?
soak: build
	@$(IN_WORKSPACE) rosrun scan_cell_demo soak --hours $(or $(HOURS),1)

# Every test under the address and undefined-behaviour sanitizers; the cores with threads under the thread sanitizer.
sanitize: dependencies
	@scripts/sanitize.sh threads; threads=$$?; scripts/sanitize.sh addresses && exit $$threads

# docs/images/shift.gif: a shift at the operator's seat, from the running cell
film: build
	@cmake --build $(BUILD) --parallel $(JOBS) --target test_scan_cell_rviz_shift
	@$(IN_WORKSPACE) scripts/film.py docs/images/shift.gif

install: build
	@cmake --install $(BUILD)

lint: dependencies docs
	@catkin_lint --offline -W2 --strict src
	@scripts/check_rooms.py
	@scripts/check_api.py
	@git ls-files '*.cpp' '*.h' | xargs -r clang-format --dry-run -Werror

# build/docs/html/index.html, from the docstrings of the API; a missing one fails
docs: dependencies
	@mkdir -p build/docs
	@doxygen docs/Doxyfile

format: dependencies
	@git ls-files '*.cpp' '*.h' | xargs -r clang-format -i

clean:
	@rm -rf build build-asan build-tsan devel install src/CMakeLists.txt

# demo, test, bench and build need nothing done before them on a fresh Debian 12.

SHELL := /bin/bash
# Where another python3 comes first on PATH (pyenv, conda), catkin and the ROS tools break.
export PATH := /usr/bin:$(PATH)
export ROS_LANG_DISABLE := genlisp:geneus:gennodejs
JOBS ?= $(shell nproc)
# simulated cells side by side in make test; each needs about a tenth of a processor
CELLS ?= $(shell echo $$((2 * $(JOBS))))
# of each reader of files, in make fuzz
RUNS ?= 2000000
# where it is built, and how; make sanitize has trees and flags of its own
BUILD ?= build
DEVEL ?= devel
FLAGS ?= -O2 -g1 -DNDEBUG
# packages, with ; between them; empty: all
WHITELIST ?=
IN_WORKSPACE = source $(DEVEL)/setup.bash &&

.PHONY: all build demo test bench fuzz trials soak sanitize install lint format clean dependencies configure

all: build

dependencies:
	@scripts/install_dependencies.sh

src/CMakeLists.txt:
	@ln -s /usr/share/catkin/cmake/toplevel.cmake $@

# -g1: lines in stack traces, a quarter of the compile time less than -g.
# catkin keeps the environment of the first configure for the tests, and leaves out directories that are not there yet.
configure: dependencies src/CMakeLists.txt
	@mkdir -p $(BUILD) $(DEVEL)/lib/pkgconfig $(DEVEL)/lib/python3/dist-packages
	@cmake -S src -B $(BUILD) -G Ninja -DCATKIN_DEVEL_PREFIX=$(abspath $(DEVEL)) -DCMAKE_INSTALL_PREFIX=$(CURDIR)/install \
	  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO='$(FLAGS)' \
	  -DCATKIN_WHITELIST_PACKAGES='$(WHITELIST)' -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
	  -DCMAKE_CXX_COMPILER_LAUNCHER=$$(command -v ccache) > $(BUILD)/configure.log 2>&1 \
	  || { cat $(BUILD)/configure.log; exit 1; }

build: configure
	@cmake --build $(BUILD) --parallel $(JOBS)

demo: build
	@scripts/demo.sh

bench: build
	@cmake --build $(BUILD) --parallel $(JOBS) --target benchmarks
	@$(IN_WORKSPACE) for bench in $(DEVEL)/lib/*/bench_*; do echo "== $$(basename $$bench)"; $$bench || exit 1; done

fuzz: build
	@cmake --build $(BUILD) --parallel $(JOBS) --target fuzzers
	@$(IN_WORKSPACE) for fuzzer in $(DEVEL)/lib/*/fuzz_*; do $$fuzzer --runs $(RUNS) || exit 1; done

test: build
	@cmake --build $(BUILD) --parallel $(JOBS) --target tests
	@$(IN_WORKSPACE) scripts/run_tests.sh $(BUILD) $(JOBS) $(CELLS)

# COUNT times emergency stop, cable pulled, controller, driver, cell or ViDeE's node killed, in mid move and in mid scan
trials: build
	@$(IN_WORKSPACE) rosrun scan_cell_demo trials --count $(or $(COUNT),200)

# HOURS of scanning with faults on the wires: does any node hold more and more?
soak: build
	@$(IN_WORKSPACE) rosrun scan_cell_demo soak --hours $(or $(HOURS),1)

# Every test under the address and undefined-behaviour sanitizers; the cores that have threads under the thread sanitizer.
sanitize: dependencies
	@scripts/sanitize.sh threads; threads=$$?; scripts/sanitize.sh addresses && exit $$threads

install: build
	@cmake --install $(BUILD)

lint: dependencies
	@catkin_lint --offline -W2 --strict src
	@scripts/check_rooms.py
	@git ls-files '*.cpp' '*.h' | xargs -r clang-format --dry-run -Werror

format: dependencies
	@git ls-files '*.cpp' '*.h' | xargs -r clang-format -i

clean:
	@rm -rf build build-asan build-tsan devel install src/CMakeLists.txt

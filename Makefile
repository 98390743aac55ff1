# demo, test, bench and build need nothing done before them on a fresh Debian 12.

SHELL := /bin/bash
# Where another python3 comes first on PATH (pyenv, conda), catkin and the ROS tools break.
export PATH := /usr/bin:$(PATH)
export ROS_LANG_DISABLE := genlisp:geneus:gennodejs
JOBS ?= $(shell nproc)
# of each reader of files, in make fuzz
RUNS ?= 2000000
IN_WORKSPACE = source devel/setup.bash &&

.PHONY: all build demo test bench fuzz install lint format clean dependencies configure

all: build

dependencies:
	@scripts/install_dependencies.sh

src/CMakeLists.txt:
	@ln -s /usr/share/catkin/cmake/toplevel.cmake $@

# -g1: lines in stack traces, a quarter of the compile time less than -g.
# catkin keeps the environment of the first configure for the tests, and leaves out directories that are not there yet.
configure: dependencies src/CMakeLists.txt
	@mkdir -p devel/lib/pkgconfig devel/lib/python3/dist-packages
	@cmake -S src -B build -DCATKIN_DEVEL_PREFIX=$(CURDIR)/devel -DCMAKE_INSTALL_PREFIX=$(CURDIR)/install \
	  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO='-O2 -g1 -DNDEBUG' \
	  -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
	  -DCMAKE_CXX_COMPILER_LAUNCHER=$$(command -v ccache) > build-configure.log 2>&1 \
	  || { cat build-configure.log; exit 1; }
	@mkdir -p build && mv build-configure.log build/configure.log

build: configure
	@cmake --build build --parallel $(JOBS)

demo: build
	@scripts/demo.sh

bench: build
	@cmake --build build --parallel $(JOBS) --target benchmarks
	@$(IN_WORKSPACE) for bench in devel/lib/*/bench_*; do echo "== $$(basename $$bench)"; $$bench || exit 1; done

fuzz: build
	@cmake --build build --parallel $(JOBS) --target fuzzers
	@$(IN_WORKSPACE) for fuzzer in devel/lib/*/fuzz_*; do $$fuzzer --runs $(RUNS) || exit 1; done

test: build
	@cmake --build build --parallel $(JOBS) --target tests
	@rm -rf build/test_results
	@$(IN_WORKSPACE) cmake --build build --parallel 1 --target run_tests
	@[ -n "$$SCAN_CELL_DATA" ] || echo "Not tested: the real parts (set SCAN_CELL_DATA to the folder that holds parts/)"
	@$(IN_WORKSPACE) set -o pipefail && catkin_test_results --all build/test_results | awk '{ print } \
	  /^Summary:/ { printf "%d passed, %d failed, %d skipped\n", $$2 - $$4 - $$6 - $$8, $$4 + $$6, $$8 }' \
	  || { scripts/failed_tests.py build/test_results; exit 1; }

install: build
	@cmake --install build

lint: dependencies
	@catkin_lint --offline -W2 --strict src
	@git ls-files '*.cpp' '*.h' | xargs -r clang-format --dry-run -Werror

format: dependencies
	@git ls-files '*.cpp' '*.h' | xargs -r clang-format -i

clean:
	@rm -rf build devel install src/CMakeLists.txt

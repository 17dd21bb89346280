// A QEMU plugin: how often each instruction of the first frame is executed, and how deep the stack grew by then.
//
//   -plugin <this>,main=<address>,begin=<address>,end=<address>,stack=<address>,stack_end=<address>,shared=<file>,out=<file>
//
// Counting starts before the first instruction at `begin` and stops before the next one at `end`. `shared` lists, a
// line each, the ranges "<first> <end>" of code that works for whoever calls it: such an instruction is counted apart
// for each caller, which is the last instruction before it outside of every range. What is written to `out`, a line
// each:
//
//   stack <bytes from stack_end down to the lowest address that was stored to, since main() began: before, the stack is painted>
//   <address> <caller, or 0> <times executed>
#include "qemu_plugin.hpp"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Instruction {
    uint64_t address = 0;
    bool is_shared = false;
    uint64_t last_caller = 0;
    uint64_t* last_count = nullptr;        // of last_caller: most callers come many times in a row
    std::map<uint64_t, uint64_t> count{};  // by caller
};

struct Range {
    uint64_t first = 0, end = 0;
    bool holds(uint64_t address) const { return address >= first && address < end; }
};

enum class Phase { before, counting, after };

struct Counter {
    uint64_t main = 0, begin = 0, end = 0;
    Range stack{};
    std::vector<Range> shared{};
    std::string out{};

    Phase phase = Phase::before;
    uint64_t lowest_store = 0;
    uint64_t caller = 0;
    std::map<uint64_t, Instruction> instructions{};  // a map, because QEMU is given the addresses of its values
};

// Never destroyed: the emulated program's exit runs this library's destructors while QEMU may still call it.
Counter& counter = *new Counter;

void write_counts() {
    FILE* const file = std::fopen(counter.out.c_str(), "w");
    if (file == nullptr) {
        std::fprintf(stderr, "instruction_counter: cannot write to '%s'.\n", counter.out.c_str());
        std::exit(1);
    }
    std::fprintf(file, "stack %llu\n", static_cast<unsigned long long>(counter.stack.end - counter.lowest_store));
    for (const auto& [address, instruction] : counter.instructions)
        for (const auto& [caller, count] : instruction.count)
            std::fprintf(file, "%08llx %08llx %llu\n", static_cast<unsigned long long>(address),
                         static_cast<unsigned long long>(caller), static_cast<unsigned long long>(count));
    std::fclose(file);
}

void change_phase(uint64_t address) {
    if (counter.phase == Phase::before && address == counter.begin) counter.phase = Phase::counting;
    if (counter.phase == Phase::counting && address == counter.end) {
        counter.phase = Phase::after;
        write_counts();
    }
}

void before_instruction(unsigned, void* data) {
    auto& instruction = *static_cast<Instruction*>(data);
    if (instruction.address == counter.begin || instruction.address == counter.end) change_phase(instruction.address);
    if (instruction.address == counter.main && counter.phase == Phase::before) counter.lowest_store = counter.stack.end;
    if (counter.phase != Phase::counting) return;
    if (!instruction.is_shared) counter.caller = instruction.address;
    const uint64_t caller = instruction.is_shared ? counter.caller : 0;
    if (instruction.last_count == nullptr || instruction.last_caller != caller) {
        instruction.last_caller = caller;
        instruction.last_count = &instruction.count[caller];
    }
    ++*instruction.last_count;
}

void at_store(unsigned, qemu_plugin_meminfo_t, uint64_t address, void*) {
    if (counter.phase != Phase::after && counter.stack.holds(address) && address < counter.lowest_store)
        counter.lowest_store = address;
}

void at_translation(qemu_plugin_id_t, qemu_plugin_tb* block) {
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
        qemu_plugin_insn* const translated = qemu_plugin_tb_get_insn(block, i);
        const uint64_t address = qemu_plugin_insn_vaddr(translated);
        Instruction& instruction = counter.instructions[address];
        instruction.address = address;
        for (const Range& range : counter.shared) instruction.is_shared = instruction.is_shared || range.holds(address);
        qemu_plugin_register_vcpu_insn_exec_cb(translated, before_instruction, QEMU_PLUGIN_CB_NO_REGS, &instruction);
        qemu_plugin_register_vcpu_mem_cb(translated, at_store, QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_MEM_W, nullptr);
    }
}

bool read_ranges(const char* name) {
    FILE* const file = std::fopen(name, "r");
    if (file == nullptr) return false;
    unsigned long long first = 0, end = 0;
    while (std::fscanf(file, "%llx %llx", &first, &end) == 2) counter.shared.push_back({first, end});
    const bool is_whole = std::feof(file) != 0;
    std::fclose(file);
    return is_whole;
}

bool take_argument(std::string_view argument) {
    const size_t equals = argument.find('=');
    if (equals == std::string_view::npos) return false;
    const std::string_view name = argument.substr(0, equals);
    const std::string value(argument.substr(equals + 1));
    const uint64_t address = std::strtoull(value.c_str(), nullptr, 0);
    if (name == "main")
        counter.main = address;
    else if (name == "begin")
        counter.begin = address;
    else if (name == "end")
        counter.end = address;
    else if (name == "stack")
        counter.stack.first = address;
    else if (name == "stack_end")
        counter.stack.end = counter.lowest_store = address;
    else if (name == "out")
        counter.out = value;
    else if (name == "shared")
        return read_ranges(value.c_str());
    else
        return false;
    return true;
}

}  // namespace

extern "C" {
__attribute__((visibility("default"))) extern const int qemu_plugin_version;
const int qemu_plugin_version = 1;

__attribute__((visibility("default"))) int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t*, int count,
                                                               char** arguments) {
    for (int i = 0; i < count; ++i) {
        if (take_argument(arguments[i])) continue;
        std::fprintf(
            stderr,
            "instruction_counter: '%s' was not understood; expected <name>=<value>, see instruction_counter.cpp.\n",
            arguments[i]);
        return 1;
    }
    if (counter.begin == 0 || counter.end == 0 || counter.out.empty()) {
        std::fprintf(stderr, "instruction_counter: begin=, end= and out= are needed.\n");
        return 1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, at_translation);
    return 0;
}
}

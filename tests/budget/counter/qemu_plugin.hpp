// The few functions of QEMU's plugin interface (version 1, QEMU 7.2) that the counter uses, declared here because no
// Debian package ships qemu-plugin.h. QEMU itself defines them.
#pragma once

#include <stddef.h>
#include <stdint.h>

extern "C" {
using qemu_plugin_id_t = uint64_t;
using qemu_plugin_meminfo_t = uint32_t;
struct qemu_info_t;
struct qemu_plugin_tb;    // a block of instructions that QEMU translates as one
struct qemu_plugin_insn;  // an instruction in it; both live only while the block is translated

enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS };
enum qemu_plugin_mem_rw { QEMU_PLUGIN_MEM_R = 1, QEMU_PLUGIN_MEM_W };

using qemu_plugin_tb_callback = void (*)(qemu_plugin_id_t, qemu_plugin_tb*);
using qemu_plugin_insn_callback = void (*)(unsigned cpu, void* data);
using qemu_plugin_mem_callback = void (*)(unsigned cpu, qemu_plugin_meminfo_t, uint64_t address, void* data);

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, qemu_plugin_tb_callback);
void qemu_plugin_register_vcpu_insn_exec_cb(qemu_plugin_insn*, qemu_plugin_insn_callback, qemu_plugin_cb_flags,
                                            void* data);
void qemu_plugin_register_vcpu_mem_cb(qemu_plugin_insn*, qemu_plugin_mem_callback, qemu_plugin_cb_flags,
                                      qemu_plugin_mem_rw, void* data);
size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb*);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb*, size_t index);
uint64_t qemu_plugin_insn_vaddr(const qemu_plugin_insn*);
}

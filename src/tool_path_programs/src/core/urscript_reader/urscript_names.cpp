// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript_reader/urscript_names.h"

#include <string_view>

#include "text/words.h"

namespace tool_path_programs {
namespace {

// The controller's limit is not public; up to this length names stay readable on the pendant.
constexpr std::size_t kLongestName = 64;

// From the script manual's lists of functions (module motion, internals, urmath, interfaces).
constexpr std::string_view kFunctionsWithoutMotion =
    "acos analog_in asin assert atan atan2 binary_list_to_integer ceil "
    "clear_interpreter conveyor_pulse_decode cos d2r encoder_enable_pulse_decode "
    "encoder_enable_set_tick_count encoder_get_tick_count encoder_set_tick_count "
    "encoder_unwind_delta_tick_count end_force_mode end_freedrive_mode "
    "end_interpreter end_screw_driving end_teach_mode floor force force_mode "
    "force_mode_set_damping force_mode_set_gain_scaling freedrive_mode "
    "freedrive_mode_no_incorrect_payload_check get_actual_joint_positions "
    "get_actual_joint_positions_history get_actual_joint_speeds get_actual_tcp_pose "
    "get_actual_tcp_speed get_actual_tool_flange_pose get_analog_in get_analog_out "
    "get_coil_temp get_configurable_digital_in get_configurable_digital_out "
    "get_controller_temp get_conveyor_tick_count get_digital_in get_digital_out "
    "get_euromap_input get_euromap_output get_flag get_forward_kin "
    "get_freedrive_status get_gravity get_inverse_kin get_inverse_kin_has_solution "
    "get_joint_temp get_joint_torques get_list_length get_standard_analog_in "
    "get_standard_analog_out get_standard_digital_in get_standard_digital_out "
    "get_steptime get_target_joint_positions get_target_joint_speeds "
    "get_target_payload get_target_payload_cog get_target_payload_inertia "
    "get_target_tcp_pose get_target_tcp_speed get_target_waypoint get_tcp_force "
    "get_tcp_offset get_tool_accelerometer_reading get_tool_analog_in "
    "get_tool_current get_tool_digital_in get_tool_digital_out "
    "high_holding_torque_disable high_holding_torque_enable integer_to_binary_list "
    "interpolate_pose inv is_steady is_within_safety_limits length list_add log "
    "make_list modbus_add_signal modbus_delete_signal modbus_get_signal_status "
    "modbus_send_custom_command modbus_set_digital_input_action "
    "modbus_set_output_register modbus_set_output_signal "
    "modbus_set_runstate_dependent_choice modbus_set_signal_update_frequency "
    "modbus_set_signal_watchdog norm normalize path_offset_disable "
    "path_offset_enable path_offset_get path_offset_set path_offset_set_alpha_filter "
    "path_offset_set_max_offset point_dist popup pose_add pose_dist pose_inv "
    "pose_sub pose_trans position_deviation_warning pow powerdown "
    "profinet_set_watchdog protective_stop r2d random read_input_boolean_register "
    "read_input_float_register read_input_integer_register "
    "read_output_boolean_register read_output_float_register "
    "read_output_integer_register read_port_bit read_port_register "
    "request_boolean_from_primary_client request_float_from_primary_client "
    "request_integer_from_primary_client request_string_from_primary_client "
    "reset_revolution_counter reset_world_model rotvec2rpy round rpc_factory "
    "rpy2rotvec rtde_set_watchdog screw_driving set_analog_inputrange set_analog_out "
    "set_analog_outputdomain set_configurable_digital_input_action "
    "set_configurable_digital_out set_conveyor_tick_count set_digital_out "
    "set_euromap_output set_euromap_runstate_dependent_choice set_flag set_gravity "
    "set_gripper set_input_actions_to_default set_payload set_payload_cog "
    "set_payload_mass set_runstate_configurable_digital_output_to_value "
    "set_runstate_gp_boolean_output_to_value "
    "set_runstate_standard_analog_output_to_value "
    "set_runstate_standard_digital_output_to_value "
    "set_runstate_tool_digital_output_to_value set_safety_mode_transition_hardness "
    "set_standard_analog_input_domain set_standard_analog_out "
    "set_standard_digital_input_action set_standard_digital_out set_target_payload "
    "set_tool_analog_input_domain set_tool_communication "
    "set_tool_digital_input_action set_tool_digital_out set_tool_output_mode "
    "set_tool_voltage sin size sleep socket_close socket_get_var socket_open "
    "socket_read_ascii_float socket_read_binary_integer socket_read_byte_list "
    "socket_read_line socket_read_string socket_send_byte socket_send_int "
    "socket_send_line socket_send_string socket_set_var sqrt stop_conveyor_tracking "
    "stopj stopl str_at str_cat str_empty str_find str_len str_sub sync tan "
    "teach_mode textmsg time to_num to_str tool_contact transpose wrench_trans "
    "write_output_boolean_register write_output_float_register "
    "write_output_integer_register write_port_bit write_port_register zero_ftsensor";

bool is_letter(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
}

bool is_digit(char character) {
  return character >= '0' && character <= '9';
}

}  // namespace

bool is_urscript_keyword(std::string_view word) {
  static const Words words = words_of(
      "and break continue def elif else end enum False global goto halt if in join "
      "kill local not or return run sec struct thread True enter_critical "
      "exit_critical while xor mod switch case default pass p");
  return words.count(word) != 0;
}

bool is_urscript_function_with_motion(std::string_view name) {
  static const Words words = words_of(
      "movej movel movep movec set_tcp speedj speedl speedj_init servoj servoj_init "
      "servol servoc optimove_j optimovej optimovel track_conveyor_linear "
      "track_conveyor_circular direct_torque torque_command");
  return words.count(name) != 0;
}

bool is_urscript_function_without_motion(std::string_view name) {
  static const Words words = words_of(kFunctionsWithoutMotion);
  return words.count(name) != 0;
}

std::string fault_of_urscript_name(const std::string& name) {
  if (name.empty()) return "an empty name";
  if (name.size() > kLongestName)
    return "'" + name.substr(0, kLongestName) + "...' has more than " +
           std::to_string(kLongestName) + " characters";
  if (urscript_name_like(name) != name)
    return "'" + name + "' is not a name of letters, digits and _, or is a word of the language";
  return "";
}

std::string urscript_name_like(const std::string& name) {
  std::string like = name.substr(0, kLongestName);
  for (char& character : like)
    if (!is_letter(character) && !is_digit(character)) character = '_';
  const bool taken = is_urscript_keyword(like) || is_urscript_function_with_motion(like) ||
                     is_urscript_function_without_motion(like);
  if (like.empty() || !is_letter(like.front()) || taken) like.insert(0, "P_");
  return like.substr(0, kLongestName);
}

}  // namespace tool_path_programs

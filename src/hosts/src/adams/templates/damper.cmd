! The damper as a GSE and an SFORCE in the current Adams View model. Units: mm, N, kg, s.
! Beforehand: markers damper_i (rod side) and damper_j (tube side) on two parts of the model; change the names below.
! Outputs: 1 SFORCE value, 2 series deflection, 3 velocity of the internal mass, 4 primary damper, 5 springs, 6 friction, 7 gas,
! 8 stops (forces tension positive), 9 oil temperature; ARYVAL(dashpot_y,n) in a request plots them.
! Afterwards: copy the model file and the library into the folder where the solver runs.
data_element create string string_name=dashpot_model_file string="{model_file}"
data_element create variable variable_name=dashpot_displacement function="DM(damper_i,damper_j)-{length}"
data_element create variable variable_name=dashpot_velocity function="VR(damper_i,damper_j)"
data_element create array u_input_array array_name=dashpot_u size=2 variable_name=dashpot_displacement,dashpot_velocity
data_element create array x_state_array array_name=dashpot_x size={states}
data_element create array y_output_array array_name=dashpot_y size=9
data_element create array ic_array array_name=dashpot_ic size={states} numbers={zeros}
part create equation general_state_equation general_state_equation_name=dashpot_gse &
  state_equation_count={states} discrete_state_equation_count=0 output_equation_count=9 &
  x_state_array_name=dashpot_x u_input_array_name=dashpot_u y_output_array_name=dashpot_y ic_array_name=dashpot_ic &
  static_hold=off implicit=off &
  user_function=(eval(dashpot_model_file.adams_id)) &
  interface_routines="dashpot_adams::Dashpot_gse_deriv","dashpot_adams::Dashpot_gse_update","dashpot_adams::Dashpot_gse_output","dashpot_adams::Dashpot_gse_samp"
force create direct single_component_force single_component_force_name=dashpot_force &
  type_of_freedom=translational action_only=off &
  i_marker_name=damper_i j_marker_name=damper_j &
  function="ARYVAL(dashpot_y,1)"

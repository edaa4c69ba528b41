(* MODE_min = 0, MODE_max = 4, MOD_max = 4, STEP_max *)
module n039_range_of_parameter #(parameter MODE = 2, parameter STEP = 1) (input wire a, output wire b);
    assign b = a;
endmodule

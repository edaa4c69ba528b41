module n038_names (input wire a, output wire b);
    genvar i;
    for (i = 0; i < 10000; i = i + 1) begin : turn_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name_with_a_long_name
        inner inner_1 (.a(a));
    end
    assign b = a;
endmodule

module inner (input wire a);
    genvar i;
    for (i = 0; i < 40; i = i + 1) begin : turn
        wire x = a;
    end
endmodule

module n050_image (input wire [7:0] code, output wire a, b, c);
    pointer_table #(.IMAGE("nowhere")) table_500 (.code(code), .pointer(), .known(a));
    pointer_table #(.IMAGE("../above")) table_501 (.code(code), .pointer(), .known(b));
    pointer_table #(.IMAGE(12)) table_502 (.code(code), .pointer(), .known(c));
endmodule

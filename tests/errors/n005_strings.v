module n005_strings (input wire [7:0] code, output wire a);
    localparam LONG = "too_long_";
    localparam EMPTY = "";
    localparam STRANGE = "a\n";
    localparam OTHER = "жук";
    pointer_table #(.IMAGE("letters ")) table_500 (.code(code), .pointer(), .known(a));
endmodule

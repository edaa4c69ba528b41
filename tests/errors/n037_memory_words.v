module n037_memory_words (input wire clk, input wire [11:0] a, output wire b);
    genvar i;
    for (i = 0; i < 4000; i = i + 1) begin : turn
        presettable_memory #(.ADDRESS_WIDTH(12)) memory (
            .clk(clk), .address(a), .write(1'b0), .write_address(a), .write_word(8'd0)
        );
    end
    assign b = a[0];
endmodule

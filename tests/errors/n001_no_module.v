// Only a comment.
`default_nettype none

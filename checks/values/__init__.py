"""The named values of `kminusone value`: what they are, their keys, the functions behind them."""

"""LTLf, linear temporal logic on finite traces: values, text, meaning, patterns and English."""

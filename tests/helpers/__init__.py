"""Shared by the tests: plain mechanisms, an independent oracle for motion and forces, random mechanisms."""

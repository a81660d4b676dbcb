"""The modes study: assembly modes and circuits."""

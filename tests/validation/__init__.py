"""Every table and figure of the dissertation (Asiri 2022), computed by the service and compared: ./dev validate."""

[assembly: InternalsVisibleTo("HostTests")]

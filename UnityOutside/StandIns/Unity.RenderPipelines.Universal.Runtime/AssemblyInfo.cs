using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("HostTests")]

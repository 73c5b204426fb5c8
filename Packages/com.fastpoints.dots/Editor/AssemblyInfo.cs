using System.Runtime.CompilerServices;

// The public types are for users; its tests see the rest.
[assembly: InternalsVisibleTo("FastPoints.UnityTests")]
[assembly: InternalsVisibleTo("FastPoints.UnityTests.Performance")]
[assembly: InternalsVisibleTo("HostTests")]

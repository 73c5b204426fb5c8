using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("UnityEditor.CoreModule")]
[assembly: InternalsVisibleTo("Unity.Collections")]
[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("FastPoints.Cli")]

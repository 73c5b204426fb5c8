using System.Runtime.CompilerServices;
using UnityEngine.Scripting;

// HttpFile registers itself.
[assembly: AlwaysLinkAssembly]

// The public types are for users; the package, its tests and its command line share the rest.
[assembly: InternalsVisibleTo("FastPoints.Import")]
[assembly: InternalsVisibleTo("FastPoints.Rendering")]
[assembly: InternalsVisibleTo("FastPoints.Rendering.BuiltIn")]
[assembly: InternalsVisibleTo("FastPoints.Rendering.Urp")]
[assembly: InternalsVisibleTo("FastPoints.Rendering.Hdrp")]
[assembly: InternalsVisibleTo("FastPoints.Entities")]
[assembly: InternalsVisibleTo("FastPoints.Scenes")]
[assembly: InternalsVisibleTo("FastPoints.Picture")]
[assembly: InternalsVisibleTo("FastPoints.Surface")]
[assembly: InternalsVisibleTo("FastPoints.Editor")]
[assembly: InternalsVisibleTo("FastPoints.Evaluation")]
[assembly: InternalsVisibleTo("FastPoints.Benchmarks")]
[assembly: InternalsVisibleTo("FastPoints.Tests")]
[assembly: InternalsVisibleTo("FastPoints.UnityTests")]
[assembly: InternalsVisibleTo("FastPoints.Cli")]
[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("MonoTests")]
[assembly: InternalsVisibleTo("PageTests")]

using System.Runtime.CompilerServices;
using UnityEngine.Scripting;

// Nothing refers to this assembly: without this, code stripping would leave the pass out of players.
[assembly: AlwaysLinkAssembly]
[assembly: InternalsVisibleTo("HostTests")]

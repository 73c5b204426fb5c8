using System;
using System.Collections.Generic;
using UnityEditor.Compilation;
using Code = System.Reflection.Assembly;

namespace FastPoints.Editor
{
    /// <summary>What the assemblies of a player tell of what it may do.</summary>
    static class PlayerScripts
    {
        const string Package = "Packages/com.fastpoints.dots/";

        /// <summary>Without it no headset is drawn for.</summary>
        const string Headsets = "Unity.XR.Management";

        /// <summary>In these it is said what points look like.</summary>
        static readonly HashSet<string> s_looks = new HashSet<string>(StringComparer.Ordinal)
        {
            "FastPoints.Entities", "FastPoints.Rendering",
        };

        public static bool HasHeadsets => Array.Exists(All, a => a.name == Headsets);

        /// <summary>An assembly of the project that may change what points look like: no more is asked than whether its code uses
        /// one in which that can be done.</summary>
        /// <returns>Its name; null where there is none.</returns>
        public static string FindChanger()
        {
            var loaded = new Dictionary<string, Code>(StringComparer.Ordinal);
            foreach (var code in AppDomain.CurrentDomain.GetAssemblies())
                loaded[code.GetName().Name] = code;
            foreach (var assembly in All)
                if (!IsOfPackage(assembly) && loaded.TryGetValue(assembly.name, out var code) && UsesLooks(code))
                    return assembly.name;
            return null;
        }

        static Assembly[] All => CompilationPipeline.GetAssemblies(AssembliesType.PlayerWithoutTestAssemblies);

        /// <summary>An assembly's metadata names what its code uses, and not all that it might use.</summary>
        static bool UsesLooks(Code code) => Array.Exists(code.GetReferencedAssemblies(), r => s_looks.Contains(r.Name));

        static bool IsOfPackage(Assembly assembly) =>
            assembly.sourceFiles.Length > 0 && assembly.sourceFiles[0].StartsWith(Package, StringComparison.Ordinal);
    }
}

using System;
using System.Collections.Generic;
using UnityEditor.Compilation;
using Code = System.Reflection.Assembly;

namespace FastPoints.Editor
{
    /// <summary>What a player's assemblies reveal of what its scripts may do.</summary>
    static class PlayerScripts
    {
        const string Package = "Packages/com.fastpoints.dots/";

        /// <summary>Without this assembly, nothing is drawn for headsets.</summary>
        const string Headsets = "Unity.XR.Management";

        /// <summary>The assemblies in which the look of points can be set.</summary>
        static readonly HashSet<string> s_looks = new HashSet<string>(StringComparer.Ordinal)
        {
            "FastPoints.Entities", "FastPoints.Rendering",
        };

        public static bool HasHeadsets => Array.Exists(All, a => a.name == Headsets);

        /// <summary>Finds an assembly of the project that may change how points look. It only checks whether the code refers to
        /// an assembly in which that can be done.</summary>
        /// <returns>Its name; null if there is none.</returns>
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

        /// <summary>Looks at metadata, which names the assemblies that the code uses, not all that it could use.</summary>
        static bool UsesLooks(Code code) => Array.Exists(code.GetReferencedAssemblies(), r => s_looks.Contains(r.Name));

        static bool IsOfPackage(Assembly assembly) =>
            assembly.sourceFiles.Length > 0 && assembly.sourceFiles[0].StartsWith(Package, StringComparison.Ordinal);
    }
}

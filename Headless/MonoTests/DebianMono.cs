using Mono.Cecil;

namespace FastPoints.MonoTests
{
    /// <summary>Makes assemblies for .NET Standard run on Debian's Mono. Debian compiles Mono's libraries with mcs (Roslyn is not
    /// built from its sources there), which leaves the modifier out that "ref readonly" results have everywhere else, Unity's
    /// Mono included: without this ReadOnlySpan's indexer is a method that is not found.</summary>
    internal static class DebianMono
    {
        public static void Adapt(string from, string to)
        {
            Directory.CreateDirectory(to);
            foreach (string file in Directory.GetFiles(from).Where(f => Path.GetExtension(f) is ".dll" or ".pdb"))
                File.Copy(file, Path.Combine(to, Path.GetFileName(file)), true);
            foreach (string file in Directory.GetFiles(to, "*.dll"))
            {
                bool hasSymbols = File.Exists(Path.ChangeExtension(file, ".pdb"));
                using var module = ModuleDefinition.ReadModule(file,
                    new ReaderParameters { InMemory = true, ReadSymbols = hasSymbols });
                if (module.AssemblyReferences.Any(r => r.Name == "netstandard") && Adapt(module) > 0)
                    module.Write(file, new WriterParameters { WriteSymbols = hasSymbols });
            }
        }

        private static int Adapt(ModuleDefinition module)
        {
            int changed = 0;
            IEnumerable<MethodReference> called = module.GetTypes().SelectMany(t => t.Methods).Where(m => m.HasBody)
                .SelectMany(m => m.Body.Instructions).Select(i => i.Operand).OfType<MethodReference>();
            foreach (MethodReference method in called.Select(m => m.GetElementMethod()))
            {
                if (method.ReturnType is not RequiredModifierType { ModifierType.Name: "InAttribute" } modified ||
                    method.DeclaringType.Scope?.Name != "netstandard")
                    continue;
                method.ReturnType = modified.ElementType;
                changed++;
            }
            return changed;
        }
    }
}

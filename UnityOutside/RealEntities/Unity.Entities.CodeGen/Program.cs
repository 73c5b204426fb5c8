using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Mono.Cecil;
using Unity.CompilationPipeline.Common.Diagnostics;
using Unity.CompilationPipeline.Common.ILPostProcessing;

namespace RealEntities
{
    /// <summary>Runs Unity's own IL post-processors over assemblies of a folder, where they lie: FOLDER NAME...</summary>
    static class Program
    {
        static readonly string[] s_framework =
            Directory.GetFiles(Path.GetDirectoryName(typeof(object).Assembly.Location), "System.*.dll");

        static int Main(string[] args)
        {
            int errors = 0;
            foreach (string name in args.Skip(1))
            {
                string file = Path.Combine(args[0], name + ".dll");
                errors += Process(new Unity.Jobs.CodeGen.JobsILPostProcessor(), name, file);
                errors += Process(new Unity.Entities.CodeGen.EntitiesILPostProcessors(), name, file);
                ShowTypes(name, file);
            }
            return errors == 0 ? 0 : 1;
        }

        static int Process(ILPostProcessor processor, string name, string file)
        {
            string symbols = Path.ChangeExtension(file, ".pdb"), folder = Path.GetDirectoryName(file);
            using var module = ModuleDefinition.ReadModule(file);
            var references = module.AssemblyReferences.Select(r => Path.Combine(folder, r.Name + ".dll")).Where(File.Exists);
            var compiled = new Compiled
            {
                Name = name,
                Defines = new[] { "ENABLE_UNITY_COLLECTIONS_CHECKS", "UNITY_64", "UNITY_STANDALONE" },
                References = references.Concat(s_framework).ToArray(),
                InMemoryAssembly = new InMemoryAssembly(File.ReadAllBytes(file), File.ReadAllBytes(symbols)),
            };
            if (!processor.WillProcess(compiled))
                return 0;
            ILPostProcessResult result = processor.Process(compiled);
            List<DiagnosticMessage> said = result?.Diagnostics ?? new List<DiagnosticMessage>();
            foreach (DiagnosticMessage message in said)
                Console.WriteLine($"{name}: {message.DiagnosticType} {message.File}:{message.Line} {message.MessageData}");
            if (result?.InMemoryAssembly != null)
            {
                File.WriteAllBytes(file, result.InMemoryAssembly.PeData);
                File.WriteAllBytes(symbols, result.InMemoryAssembly.PdbData);
            }
            return said.Count(m => m.DiagnosticType == DiagnosticType.Error);
        }

        /// <summary>What was put in names types that are private, of Unity's assemblies from all others. Mono lets it, .NET does
        /// not. The package's own stay out of other assemblies' sight: tests look at what is public.</summary>
        static void ShowTypes(string name, string file)
        {
            bool isUnitys = name.StartsWith("Unity.", StringComparison.Ordinal);
            using var resolver = new DefaultAssemblyResolver();
            resolver.AddSearchDirectory(Path.GetDirectoryName(file));
            var reading = new ReaderParameters { AssemblyResolver = resolver };
            using var module = ModuleDefinition.ReadModule(new MemoryStream(File.ReadAllBytes(file)), reading);
            foreach (TypeDefinition type in module.GetTypes().Where(t => t.Name[0] != '<'))
            {
                if (isUnitys && !type.IsNested)
                    type.IsPublic = true;
                else if (isUnitys)
                    type.IsNestedPublic = true;
                else if (type.IsNestedPrivate)
                    type.IsNestedAssembly = true;
            }
            module.Write(file);
        }

        sealed class Compiled : ICompiledAssembly
        {
            public InMemoryAssembly InMemoryAssembly { get; set; }
            public string Name { get; set; }
            public string[] References { get; set; }
            public string[] Defines { get; set; }
        }
    }
}

namespace UnityEditor
{
    class InitializeOnLoadMethodAttribute : Attribute { }
}

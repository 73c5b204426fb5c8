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
        static readonly string[] s_framework = Directory.GetFiles(Path.GetDirectoryName(typeof(object).Assembly.Location), "*.dll")
            .Where(f => Path.GetFileName(f).StartsWith("System.", StringComparison.Ordinal) || f.EndsWith("netstandard.dll", StringComparison.Ordinal)).ToArray();

        static int Main(string[] args)
        {
            int errors = 0;
            foreach (string name in args.Skip(1))
            {
                string file = Path.Combine(args[0], name + ".dll");
                foreach (ILPostProcessor processor in new ILPostProcessor[] { new Unity.Jobs.CodeGen.JobsILPostProcessor(), new Unity.Entities.CodeGen.EntitiesILPostProcessors() })
                    errors += Process(processor, name, file);
                ShowTypes(file);
            }
            return errors == 0 ? 0 : 1;
        }

        static int Process(ILPostProcessor processor, string name, string file)
        {
            string symbols = Path.ChangeExtension(file, ".pdb");
            using var module = ModuleDefinition.ReadModule(file);
            string[] references = module.AssemblyReferences.Select(r => Path.Combine(Path.GetDirectoryName(file), r.Name + ".dll")).Where(File.Exists).ToArray();
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
                Console.WriteLine($"{name}: {processor.GetType().Name}: {message.DiagnosticType} {message.File}:{message.Line} {message.MessageData}");
            if (result?.InMemoryAssembly != null)
            {
                File.WriteAllBytes(file, result.InMemoryAssembly.PeData);
                File.WriteAllBytes(symbols, result.InMemoryAssembly.PdbData);
            }
            return said.Count(m => m.DiagnosticType == DiagnosticType.Error);
        }

        /// <summary>What was put in names types that are private. Mono lets it, .NET does not.</summary>
        static void ShowTypes(string file)
        {
            using var resolver = new DefaultAssemblyResolver();
            resolver.AddSearchDirectory(Path.GetDirectoryName(file));
            using var module = ModuleDefinition.ReadModule(new MemoryStream(File.ReadAllBytes(file)), new ReaderParameters { AssemblyResolver = resolver });
            foreach (TypeDefinition type in module.GetTypes().Where(t => t.Name[0] != '<'))
            {
                if (type.IsNested)
                    type.IsNestedPublic = true;
                else
                    type.IsPublic = true;
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

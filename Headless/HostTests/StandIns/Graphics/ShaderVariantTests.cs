using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using FastPoints.HostTests.Cli;
using NUnit.Framework;
using StandIns.Graphics;

namespace FastPoints.HostTests.StandIns.Graphics
{
    /// <summary>
    /// Every shader of the package and of these tests, in every variant, through the compiler and SPIR-V's own checker.
    /// </summary>
    public sealed class ShaderVariantTests
    {
        // More would take minutes: then keywords want to become uniforms.
        private const long MostVariants = 256;

        private static readonly string[] s_folders = { "Packages", "Headless/HostTests" };

        private static IEnumerable<string> Shaders() => Checkout.Files().Where(f => s_folders.Any(f.StartsWith)
            && (f.EndsWith(".shader", StringComparison.Ordinal) || f.EndsWith(".compute", StringComparison.Ordinal)));

        [TestCaseSource(nameof(Shaders))]
        public void Variants_OfAShader_AreValid(string shader)
        {
            if (!ShaderCompiler.IsThere)
                Assert.Ignore("glslangValidator is not installed (Debian, Ubuntu: apt-get install glslang-tools)");
            if (!HasChecker())
                Assert.Ignore("spirv-val is not installed (Debian, Ubuntu: apt-get install spirv-tools)");
            using var folder = new ScratchFolder();
            Func<byte[]>[] all = Codes(Path.Combine(Checkout.Repository.Root, shader)).ToArray();
            Assert.That(all.Length, Is.LessThanOrEqualTo(MostVariants));
            var faults = new string[all.Length];
            Parallel.For(0, all.Length, i =>
            {
                File.WriteAllBytes(folder[i + ".spv"], all[i]());
                faults[i] = Check(folder[i + ".spv"]);
            });
            Assert.That(faults.Where(f => f.Length > 0), Is.Empty);
        }

        // Each kernel or stage in each variant, compiled when it is called.
        private static IEnumerable<Func<byte[]>> Codes(string path)
        {
            if (path.EndsWith(".compute", StringComparison.Ordinal))
            {
                var source = new ComputeSource(path);
                foreach (string kernel in source.Kernels)
                    for (long i = 0; i < KeywordVariant.Count(source.Keywords); i++)
                    {
                        long variant = i;
                        yield return () => source.Code(kernel, variant);
                    }
                yield break;
            }
            foreach (ShaderPass pass in ShaderLabReader.Read(path).Passes)
                for (long i = 0; i < KeywordVariant.Count(pass.Keywords); i++)
                {
                    long variant = i;
                    yield return () => pass.VertexCode(variant);
                    yield return () => pass.FragmentCode(variant);
                }
        }

        private static bool HasChecker()
        {
            try
            {
                using Process process = Start("--version");
                process.WaitForExit();
                return true;
            }
            catch (Win32Exception)
            {
                return false;
            }
        }

        private static string Check(string file)
        {
            using Process process = Start($"--relax-block-layout --target-env vulkan1.1 \"{file}\"");
            string said = process.StandardError.ReadToEnd();
            process.WaitForExit();
            return process.ExitCode == 0 ? "" : said;
        }

        private static Process Start(string arguments) => Process.Start(new ProcessStartInfo("spirv-val", arguments)
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        });
    }
}

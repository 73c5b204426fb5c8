using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Reading;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Build
{
    public class ConvertSamplesTests
    {
        /// <summary>Every file that can be read becomes a cloud of the same points; one that cannot leaves nothing
        /// behind.</summary>
        [Test, Category("Long"), Explicit]
        public void Convert_EverySample_KeepsEveryPoint([Values("las", "laz", "ply", "broken")] string kind)
        {
            if (TestData.Samples == null)
                Assert.Ignore("no samples: set FASTPOINTS_DATA");
            using var scratch = new TemporaryFolder();
            var problems = new List<string>();
            int converted = 0;
            string[] files = Directory.GetFiles(Path.Combine(TestData.Samples, kind));
            foreach (string file in files.OrderBy(f => f, StringComparer.Ordinal))
            {
                string problem = Prove(file, scratch.File("c.fastpoints"), ref converted);
                if (problem != null)
                    problems.Add(Path.GetFileName(file) + ": " + problem);
            }
            Assert.That(problems, Is.Empty);
            Assert.That(converted, Is.GreaterThan(0));
        }

        static string Prove(string file, string target, ref int converted)
        {
            PointReader reader;
            try
            {
                reader = PointReaders.Open(file);
            }
            catch (PointCloudException)
            {
                return null;
            }
            using (reader)
            {
                try
                {
                    JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, target, new ConvertSettings(), r => { }, null));
                }
                catch (PointCloudException)
                {
                    return Directory.Exists(target) || Directory.Exists(target + ".part")
                        ? "a failed conversion left something"
                        : null;
                }
                converted++;
                var result = new VerifyResult();
                JobCoroutine.RunToEnd(VerifyCloud.Run(target, new[] { reader }, result, null));
                Directory.Delete(target, true);
                return result.Ok ? null : result.Problems[0];
            }
        }
    }
}

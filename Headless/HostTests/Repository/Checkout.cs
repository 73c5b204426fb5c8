using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using FastPoints.RepoTools;
using FastPoints.RepoTools.Api;

namespace FastPoints.HostTests
{
    /// <summary>The checkout that the tests were built in.</summary>
    internal static class Checkout
    {
        internal static readonly RepoTools.Repository Repository = RepoTools.Repository.Find();

        /// <summary>Paths of the files that are committed or would be, with '/'.</summary>
        internal static IReadOnlyList<string> Files()
        {
            var start = new ProcessStartInfo("git", "ls-files --cached --others --exclude-standard")
            {
                WorkingDirectory = Repository.Root,
                RedirectStandardOutput = true,
            };
            using Process git = Process.Start(start);
            string output = git.StandardOutput.ReadToEnd();
            git.WaitForExit();
            if (git.ExitCode != 0)
                throw new ToolException("git ls-files failed");
            return output.Split('\n').Where(f => f.Length > 0 && System.IO.File.Exists(System.IO.Path.Combine(Repository.Root, f))).ToList();
        }

        /// <summary>The builds of one generation; what to run where they are absent.</summary>
        internal static GenerationBuilds Builds(string generation) => new GenerationBuilds(Repository, generation);
    }
}

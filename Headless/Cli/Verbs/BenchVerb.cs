using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using FastPoints.Base;
using FastPoints.Benchmarks;
using FastPoints.Cli.Stability;

namespace FastPoints.Cli.Verbs
{
    /// <summary>Runs workloads and prints what they took, as ratios to what bounds them.</summary>
    public sealed class BenchVerb : Verb
    {
        readonly Argument<string[]> m_names = new("NAME")
        {
            Arity = ArgumentArity.ZeroOrMore,
            Description = "Workloads whose name contains this (default: all). --list names them. stability: extremes of input through every "
                + "stage, with error, time, memory and outcome.",
        };
        readonly Option<string?> m_baseline = new("--baseline")
        {
            HelpName = "FILE",
            Description = "The --json summary of an earlier run on this machine: each workload's time is given as a share of its.",
        };
        readonly Option<int> m_points = new("--points")
        {
            HelpName = "N",
            Description = "Points that a made input has (default: 4,000,000).",
            DefaultValueFactory = _ => 4_000_000,
        };
        readonly Option<int> m_runs = new("--runs")
        {
            HelpName = "N",
            Description = "Timed runs of each workload, interleaved (default: 7). The median counts.",
            DefaultValueFactory = _ => 7,
        };
        readonly Option<bool> m_list = new("--list") { Description = "Name the workloads and run none." };

        public BenchVerb() : base(new Command("bench", "Run the benchmarks: median times, speeds, errors, garbage, and ratios to what "
            + "bounds each workload in the same run."))
        {
            Command.Add(m_names);
            Command.Add(m_baseline);
            Command.Add(m_points);
            Command.Add(m_runs);
            Command.Add(m_list);
            AddCommonOptions();
        }

        public override IReadOnlyList<(string, string)> Examples =>
        [
            ("./fastpoints bench", "all workloads"),
            ("./fastpoints bench las --json las.json", "those with las in their name"),
            ("./fastpoints bench stability --points 1000000", "extremes of input, a million points each"),
            ("./fastpoints bench --baseline before.json", "compare with an earlier run"),
        ];

        public override void Run(ParseResult parsed, CliRun run)
        {
            var names = parsed.GetValue(m_names) ?? [];
            if (names is ["stability"])
            {
                StabilityTable.Run(parsed.GetResult(m_points)?.Implicit == false ? parsed.GetValue(m_points) : StabilityTable.DefaultPoints, run);
                return;
            }
            var all = WorkloadList.All();
            var chosen = all.Where(w => names.Length == 0 || names.Any(n => w.Name.Contains(n, StringComparison.OrdinalIgnoreCase))).ToList();
            if (chosen.Count == 0)
                throw new UsageException("no workload is called that: " + string.Join(", ", names) + " (--list names them)");
            // A workload without its limit would be a time without a meaning.
            foreach (var limit in all.Where(w => chosen.Any(c => c.LimitName == w.Name) && !chosen.Contains(w)).ToList())
                chosen.Add(limit);
            if (parsed.GetValue(m_list))
            {
                foreach (var workload in chosen)
                    run.Out.WriteLine(workload.Name + (workload.LimitName == null ? "" : "   (limit: " + workload.LimitName + ")"));
                return;
            }
            int points = parsed.GetValue(m_points), runs = parsed.GetValue(m_runs);
            if (points < 1 || runs < 1)
                throw new UsageException("--points and --runs are at least 1");
            var baseline = parsed.GetValue(m_baseline) is { } path ? Baseline.Read(path) : null;

            string scratch = Directory.CreateTempSubdirectory("fastpoints-bench-").FullName;
            try
            {
                var context = new WorkloadContext { ScratchFolder = scratch, Points = points, DataFolder = DataFolder() };
                var results = new List<Measurement>();
                // A workload and its limit are timed in turns, so that both see the same moments of a busy machine.
                foreach (var group in chosen.GroupBy(w => w.LimitName ?? w.Name))
                    results.AddRange(Measurement.Take(group.ToList(), context, runs, run));
                run.WriteKeys = json => WriteJson(json, results);
                WriteTable(run, results, baseline);
            }
            finally
            {
                Directory.Delete(scratch, recursive: true);
            }
        }

        static string? DataFolder()
        {
            string? named = Environment.GetEnvironmentVariable("FASTPOINTS_DATA");
            return named != null && Directory.Exists(named) ? named : null;
        }

        static void WriteTable(CliRun run, List<Measurement> results, Dictionary<string, double>? baseline)
        {
            var heads = new List<string> { "workload", "ms", "points/s", "MB/s", "x limit", "error", "garbage" };
            if (baseline != null)
                heads.Add("x baseline");
            var table = new TextTable(heads.ToArray());
            foreach (var m in results)
            {
                if (m.Points == 0 && m.Bytes == 0)
                {
                    table.Add(m.Name, "no input");
                    continue;
                }
                var limit = results.FirstOrDefault(r => r.Name == m.LimitName);
                var cells = new List<string>
                {
                    m.Name,
                    m.Ms.ToString("0.000", CultureInfo.InvariantCulture),
                    m.PointsPerSecond > 0 ? Human.Short(m.PointsPerSecond) : "",
                    m.BytesPerSecond > 0 ? (m.BytesPerSecond / 1e6).ToString("N0", CultureInfo.InvariantCulture) : "",
                    limit != null ? m.RatioTo(limit).ToString("0.00", CultureInfo.InvariantCulture) : "",
                    m.ErrorUnit != null ? Human.Value(m.Error) + " " + m.ErrorUnit : "",
                    Human.Bytes(m.GarbageBytes),
                };
                if (baseline != null)
                    cells.Add(baseline.TryGetValue(m.Name, out double ms) ? (m.Ms / ms).ToString("0.00", CultureInfo.InvariantCulture) : "new");
                table.Add(cells.ToArray());
            }
            table.Write(run.Out, "");
            run.Out.WriteLine();
            foreach (var m in results.Where(m => m.Note != null))
                run.Out.WriteLine(m.Name + ": " + m.Note);
            run.Out.WriteLine($"{Threads.InUse} threads, median of interleaved runs; \"x limit\": time by point over the limit's of the same run.");
        }

        static void WriteJson(Utf8JsonWriter json, List<Measurement> results)
        {
            json.WriteStartArray("workloads");
            foreach (var m in results)
            {
                json.WriteStartObject();
                json.WriteString("name", m.Name);
                json.WriteReal("ms", m.Ms);
                json.WriteReal("pointsPerSecond", m.PointsPerSecond);
                json.WriteReal("bytesPerSecond", m.BytesPerSecond);
                json.WriteReal("error", m.Error);
                json.WriteInteger("garbageBytes", m.GarbageBytes);
                if (m.Note != null)
                    json.WriteString("note", m.Note);
                json.WriteEndObject();
            }
            json.WriteEndArray();
        }

        static class Baseline
        {
            public static Dictionary<string, double> Read(string path)
            {
                try
                {
                    using var document = JsonDocument.Parse(File.ReadAllBytes(path));
                    return document.RootElement.GetProperty("workloads").EnumerateArray()
                        .ToDictionary(w => w.GetProperty("name").GetString()!, w => w.GetProperty("ms").GetDouble());
                }
                catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
                {
                    throw new PointCloudException(FailureCode.NotFound, path, -1, "no such file", e);
                }
                catch (Exception e) when (e is JsonException or KeyNotFoundException or InvalidOperationException)
                {
                    throw new PointCloudException(FailureCode.BadInput, path, -1, "is not the --json summary of a bench run", e);
                }
            }
        }
    }
}

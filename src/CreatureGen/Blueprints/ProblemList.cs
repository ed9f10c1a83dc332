using System.Collections.Generic;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>Collects problems, up to a number that nobody reads to the end.</summary>
internal sealed class ProblemList
{
    /// <summary>Problems beyond these are not kept.</summary>
    public const int Maximum = 1000;

    private readonly string root;
    private readonly List<Problem> problems = new();

    /// <summary>Starts without problems.</summary>
    /// <param name="root">How the whole is called, whose own path is empty.</param>
    public ProblemList(string root) => this.root = root;

    /// <summary>The problems in the order they were found.</summary>
    public IReadOnlyList<Problem> All => problems;

    /// <summary>Adds a problem of a value in memory.</summary>
    public void Add(string path, string value, string expectation) => Add(new Problem(path, value, expectation));

    /// <summary>Adds a problem of a value in a text.</summary>
    public void Add(JsonPosition position, string path, string value, string expectation) =>
        Add(new Problem(path, value, expectation, position.Line, position.Column));

    private void Add(Problem problem)
    {
        if (problems.Count < Maximum)
        {
            problems.Add(problem.Path.Length > 0 ? problem : problem with { Path = root });
        }
    }
}

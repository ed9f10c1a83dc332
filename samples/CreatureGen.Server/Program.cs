using System;
using System.Threading;
using System.Threading.Tasks;
using System.Threading.RateLimiting;
using CreatureGen.Blueprints;
using CreatureGen.Server;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.RateLimiting;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;

WebApplicationBuilder builder = WebApplication.CreateBuilder(args);

// A creature takes a processor for a while: no more at once than there are, and a queue that is worth waiting in.
int atOnce = builder.Configuration.GetValue("AtOnce", Environment.ProcessorCount);
int waiting = builder.Configuration.GetValue("Waiting", 64);
builder.Services.AddRateLimiter(limits =>
{
    limits.RejectionStatusCode = StatusCodes.Status503ServiceUnavailable;
    limits.OnRejected = (rejected, _) =>
    {
        rejected.HttpContext.Response.Headers.RetryAfter = "1";
        return ValueTask.CompletedTask;
    };
    limits.AddConcurrencyLimiter("creatures", options =>
    {
        options.PermitLimit = atOnce;
        options.QueueLimit = waiting;
        options.QueueProcessingOrder = QueueProcessingOrder.OldestFirst;
    });
});

WebApplication app = builder.Build();
app.UseRateLimiter();
app.MapGet("/health", () => Results.Ok(new { status = "healthy", library = CreatureRequest.Library, algorithm = CreatureBlueprint.CurrentAlgorithm }));
app.MapGet("/creature/{name}", (string name, HttpContext context, CancellationToken cancellation) =>
{
    if (!CreatureRequest.TryRead(name, context.Request.Query, out CreatureRequest? request, out string problem))
    {
        return Results.Problem(problem, statusCode: StatusCodes.Status400BadRequest);
    }

    // The same request is answered with the same bytes for as long as the library is the same: who has them need not have them made again.
    context.Response.Headers.ETag = request!.Tag;
    context.Response.Headers.CacheControl = "public, max-age=86400";
    if (context.Request.Headers.IfNoneMatch.ToString().Contains(request.Tag, StringComparison.Ordinal))
    {
        return Results.StatusCode(StatusCodes.Status304NotModified);
    }

    try
    {
        return Results.Bytes(CreatureMaker.Make(request, cancellation), request.MediaType);
    }
    catch (OperationCanceledException) when (cancellation.IsCancellationRequested)
    {
        return Results.Empty;
    }
    catch (ArgumentException impossible)
    {
        context.Response.Headers.CacheControl = "no-store";
        return Results.Problem(impossible.Message, statusCode: StatusCodes.Status404NotFound);
    }
}).RequireRateLimiting("creatures");
app.Run();

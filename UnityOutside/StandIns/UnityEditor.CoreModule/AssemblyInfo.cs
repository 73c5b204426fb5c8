[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("UnityEditor.AssetPipelineEditorModule")]
[assembly: InternalsVisibleTo("UnityEditor.TestRunner")]

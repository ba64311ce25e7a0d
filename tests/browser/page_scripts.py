"""JavaScript that the tests run in a page of JupyterLab."""

ALL_RAN = """() => jupyterapp.shell.currentWidget.content.widgets
    .every((cell) => cell.model.type !== 'code' || cell.model.executionCount)"""
TO_THE_END = """async () => {
    const { content } = jupyterapp.shell.currentWidget;
    await content.scrollToItem(content.widgets.length - 1, 'end');
}"""
PROMPTS = "() => jupyterapp.shell.currentWidget.content.widgets.map((cell) => cell.model.executionCount ?? cell.model.type)"
HAS_KERNEL = "() => jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.connectionStatus === 'connected'"
ANSWERS = """async () => {
    const kernel = jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel;
    const asked = async () => {
        await kernel.info;
        await kernel.requestExecute({ code: 'None', store_history: false }).done;
        return kernel.connectionStatus === 'connected';
    };
    const late = new Promise((done) => setTimeout(() => done(false), 8000));
    return kernel ? await Promise.race([asked(), late]) : await late;
}"""
ASK = """async (code) => {
    const kernel = window.jupyterapp.shell.currentWidget.sessionContext.session.kernel;
    const future = kernel.requestExecute({ code, store_history: false });
    let text = '';
    future.onIOPub = (message) => {
        if (message.header.msg_type === 'stream') text += message.content.text;
        if (message.header.msg_type === 'error') text += message.content.traceback.join('\\n');
    };
    await future.done;
    return text;
}"""
BROKEN_WORDS = """(node) => {
    const broken = [];
    const texts = document.createTreeWalker(node, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) {
        for (const { 0: word, index } of texts.currentNode.data.matchAll(/\\w+/g)) {
            const range = document.createRange();
            range.setStart(texts.currentNode, index);
            range.setEnd(texts.currentNode, index + word.length);
            if (new Set([...range.getClientRects()].map((line) => Math.round(line.top))).size > 1) broken.push(word);
        }
    }
    return broken;
}"""
"""The words below an element that begin in one line and end in the next."""

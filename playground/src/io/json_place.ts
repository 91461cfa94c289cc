const BLANKS = /[ \t\r\n]*/;
const SIGN = /([{}[\],:])/; // the first group
const TEXT = /("(?:[^"\\\x00-\x1f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*")/; // the second group
const OTHER = /(?:-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?|true|false|null)(?![\w.+-])/;

/** What JSON allows at a place. `first` is the place after an opening bracket. */
type Expected = 'value' | 'first value' | 'key' | 'first key' | 'colon' | 'separator';

/** Follows the tokens of a text. */
class SyntaxChecker {
  private readonly closing: string[] = [];
  private expected: Expected = 'value';

  /** Takes the next token. Returns whether it is allowed. `sign` is a bracket or another sign. */
  take(sign: string | undefined, isText: boolean): boolean {
    const { expected } = this;
    if (sign === '{' || sign === '[') return this.open(sign);
    if (sign === '}' || sign === ']') return this.close(sign);
    if (sign === ':') return this.goOn(expected === 'colon', 'value');
    if (sign === ',') {
      const next = this.closing[this.closing.length - 1] === '}' ? 'key' : 'value';
      return this.goOn(expected === 'separator' && this.closing.length > 0, next);
    }
    if (expected === 'key' || expected === 'first key') return this.goOn(isText, 'colon');
    return this.goOn(this.allowsValue, 'separator');
  }

  private get allowsValue(): boolean {
    return this.expected === 'value' || this.expected === 'first value';
  }

  private goOn(isAllowed: boolean, next: Expected): boolean {
    this.expected = next;
    return isAllowed;
  }

  private open(sign: string): boolean {
    const isAllowed = this.allowsValue;
    this.closing.push(sign === '{' ? '}' : ']');
    return this.goOn(isAllowed, sign === '{' ? 'first key' : 'first value');
  }

  private close(sign: string): boolean {
    const first = sign === '}' ? 'first key' : 'first value';
    const isAllowed = this.expected === 'separator' || this.expected === first;
    return this.closing.pop() === sign && this.goOn(isAllowed, 'separator');
  }
}

/** Returns the index of the first character that makes a text no JSON. Requires: the text is no JSON. */
export function firstSyntaxError(text: string): number {
  const checker = new SyntaxChecker();
  const token = new RegExp(`${BLANKS.source}(?:${SIGN.source}|${TEXT.source}|${OTHER.source})`, 'y');
  const blanks = new RegExp(BLANKS, 'y');
  for (let at = 0; ; at = token.lastIndex) {
    blanks.lastIndex = at;
    const start = at + blanks.exec(text)![0].length;
    token.lastIndex = at;
    const found = token.exec(text);
    if (!found || !checker.take(found[1], found[2] !== undefined)) return start;
  }
}
